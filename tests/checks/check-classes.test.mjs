import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { checkClasses, kindOfMember, scan } from './check-classes.mjs';

const CLASS = `
namespace a {
//! class Commented { int not_; };
template <typename T>
class Kept final : public Base<T> {
 public:
  explicit Kept(int i) : i_{i}, f_(f(")")) {}
  int open = 0;
  [[nodiscard]] int value() const { return i_; }

 private:
  struct Inner {
    int one;
    int two;
  };
  static constexpr double kHalf = 0.5;
  void plain();
  [[nodiscard]] std::map<int, std::pair<int, int>> template_(int a,
                                                             int b) const;
  bool inline_() const { return true; }

  int i_;
  std::function<int(const std::vector<int>&)> f_;
  std::array<int, 2> pair_{{1, 2}};
  std::vector<int> list_ = make(1, 2);
  const char* text_ = "; int x; {";
};
}  // namespace a
`;

test('private methods and fields of a class are counted, and nothing else', () => {
  expect(scan(CLASS).classes).toEqual([{ name: 'Kept', line: 4, methods: 3, fields: 5 }]);
});

test('a record is not counted', () => {
  expect(scan('struct Record { int a; int b; void f(); };').classes).toEqual([]);
});

test('a function is measured from its first line to its last', () => {
  const source =
    'namespace a {\n\nint f(int a,\n      int b) {\n  if (a) {\n    return b;\n  }\n  return a;\n}\n}\n';
  expect(scan(source).functions).toEqual([{ name: 'f', line: 3, lines: 7 }]);
});

test('a member initialised in braces is no function', () => {
  expect(scan(CLASS).functions.map(({ name }) => name)).toEqual(['Kept', 'value', 'inline_']);
});

test('a lambda belongs to the function that it stands in', () => {
  const source = 'void f() {\n  const auto g = [](int i) {\n    return i;\n  };\n  g(1);\n}\n';
  expect(scan(source).functions).toHaveLength(1);
});

test('tables in braces are no functions', () => {
  expect(scan('constexpr std::array<Row, 1> kRows{{{"a", &f, 1.0}}};').functions).toEqual([]);
});

test('members are told apart', () => {
  expect(kindOfMember(' std::function<void(int)> call_')).toBe('field');
  expect(kindOfMember(' int x_ = f(1)')).toBe('field');
  expect(kindOfMember(' void call(int x = 1)')).toBe('method');
  expect(kindOfMember(' Kept& operator=(const Kept&) = delete')).toBe('method');
  expect(kindOfMember(' using Base::Base')).toBeNull();
});

test('each breach is named with its place', () => {
  const root = mkdtempSync(join(tmpdir(), 'liftarm-classes-'));
  mkdirSync(join(root, 'core/search'), { recursive: true });
  writeFileSync(join(root, 'core/search/kept.h'), CLASS);
  const limits = { folders: ['core/search'], methods: 2, fields: 4, lines: 60 };
  expect(checkClasses(root, limits)).toEqual([
    'core/search/kept.h:4: Kept has 3 private methods, 2 at most',
    'core/search/kept.h:4: Kept has 5 fields, 4 at most',
  ]);
  expect(checkClasses(root, { ...limits, methods: 15, fields: 15 })).toEqual([]);
  rmSync(root, { recursive: true });
});
