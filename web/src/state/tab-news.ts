/** What one tab tells the others about a sketch. */
export type News =
  | { readonly kind: 'written'; readonly id: string; readonly revision: number }
  | { readonly kind: 'removed'; readonly id: string };

/** Between the tabs of one browser that show the same page. A tab does not hear itself. */
export interface TabNews {
  tell(news: News): void;
  listen(hear: (news: News) => void): void;
}

/** Nobody to tell: where the browser has no channel, each write still looks before it writes. */
export const NO_NEWS: TabNews = { tell: () => undefined, listen: () => undefined };

export function openTabNews(name: string): TabNews {
  if (typeof BroadcastChannel === 'undefined') {
    return NO_NEWS;
  }
  const channel = new BroadcastChannel(name);
  return {
    tell: (news) => channel.postMessage(news),
    listen: (hear) => {
      channel.onmessage = ({ data }: MessageEvent<unknown>) => {
        const news = readNews(data);
        if (news) {
          hear(news);
        }
      };
    },
  };
}

/** Tabs may show different versions of the page. */
function readNews(value: unknown): News | null {
  if (typeof value !== 'object' || value === null) {
    return null;
  }
  const { kind, id, revision } = value as Record<string, unknown>;
  if (typeof id !== 'string') {
    return null;
  }
  if (kind === 'removed') {
    return { kind, id };
  }
  return kind === 'written' && typeof revision === 'number' ? { kind, id, revision } : null;
}
