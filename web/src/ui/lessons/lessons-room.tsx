/** To come. */
export function LessonsRoom() {
  return <p />;
}
