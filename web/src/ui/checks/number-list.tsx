import './number-list.css';

/** Numbers of a check with their names, one in a row. */
export function NumberList({ rows }: { readonly rows: readonly (readonly [string, string])[] }) {
  return (
    <dl class="number-list">
      {rows.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
