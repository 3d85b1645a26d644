// Which folders of tests/core a change touches.

/** Files that every native test is built with. */
const ALL =
  /^(CMakeLists\.txt|CMakePresets\.json|scripts\/cmake\/|tests\/CMakeLists\.txt|tests\/core\/helpers\/)/;

/**
 * @param {string[]} files that a change touches, from the top of the repository
 * @param {string[]} folders of tests/core
 * @returns {string[]} those whose code or tests are among them; all where a file is that all are built with.
 */
export function touchedFolders(files, folders) {
  if (files.some((file) => ALL.test(file))) {
    return folders;
  }
  const touched = new Set(files.map((file) => /^(?:tests\/)?core\/(\w+)\//.exec(file)?.[1]));
  return folders.filter((folder) => touched.has(folder));
}
