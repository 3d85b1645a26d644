declare module '@wasm/liftarm-lab.js' {
  const createLiftarmLab: import('../solver-module.ts').CreateSolverModule;
  // biome-ignore lint/style/noDefaultExport: Emscripten's module has one
  export default createLiftarmLab;
}
