declare module '@wasm/liftarm-linkages.js' {
  const createLiftarmLinkages: import('./linkage-module.ts').CreateLinkageModule;
  // biome-ignore lint/style/noDefaultExport: Emscripten's module has one
  export default createLiftarmLinkages;
}
