import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Page } from './page.ts';

const PageContext = createContext<Page | null>(null);

export const PageProvider = PageContext.Provider;

/** The page that a component belongs to. */
export function usePage(): Page {
  const page = useContext(PageContext);
  if (!page) {
    throw new Error('a component is used outside of the page');
  }
  return page;
}
