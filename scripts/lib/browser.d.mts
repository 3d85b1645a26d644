export const BROWSER: { readonly executablePath: string; readonly chromiumSandbox: boolean };
