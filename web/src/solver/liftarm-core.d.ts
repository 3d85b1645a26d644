declare module '@wasm/liftarm-core.js' {
  const createLiftarmCore: import('./solver-module.ts').CreateSolverModule;
  // biome-ignore lint/style/noDefaultExport: Emscripten's module has one
  export default createLiftarmCore;
}
