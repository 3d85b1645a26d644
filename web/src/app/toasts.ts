import { type ReadonlySignal, signal } from '@preact/signals';
import type { Toast } from '../ui/page.ts';

const INFO_MS = 4000;
const MAX_SHOWN = 4;

/** The short messages on screen. */
export class Toaster {
  readonly #toasts = signal<readonly Toast[]>([]);
  readonly toasts: ReadonlySignal<readonly Toast[]> = this.#toasts;
  #lastId = 0;

  info(message: string): void {
    const id = this.#add('info', message);
    setTimeout(() => this.dismiss(id), INFO_MS);
  }

  /** Stays until it is closed, or until the next file is opened. */
  error(message: string, action?: Toast['action']): void {
    this.#add('error', message, action);
  }

  /** Something is under way that can be cancelled; stays until what is returned is called. */
  busy(message: string, action: Toast['action']): () => void {
    const id = this.#add('info', message, action);
    return () => this.dismiss(id);
  }

  dismiss(id: number): void {
    this.#toasts.value = this.#toasts.value.filter((toast) => toast.id !== id);
  }

  clearErrors(): void {
    this.#toasts.value = this.#toasts.value.filter((toast) => toast.kind !== 'error');
  }

  #add(kind: Toast['kind'], message: string, action?: Toast['action']): number {
    this.#lastId += 1;
    const others = this.#toasts.value.filter((toast) => toast.message !== message);
    const toast = { id: this.#lastId, kind, message, ...(action ? { action } : {}) };
    this.#toasts.value = [...others, toast].slice(-MAX_SHOWN);
    return this.#lastId;
  }
}
