package org.pendant.kit.action;

import java.util.function.BooleanSupplier;

/**
 * Action: something that people can do.
 *
 * @param id stable name in settings, such as {@code program.run}
 * @param title what menus and palette show, such as {@code Run program}
 * @param keys the key as {@link javax.swing.KeyStroke#getKeyStroke(String)} reads it, such as
 *     {@code F5} or {@code control shift P}; empty for none
 * @param enabled whether it can be done now
 * @param run does it, on the dispatch thread
 */
public record Action(String id, String title, String keys, BooleanSupplier enabled, Runnable run) {

  /** An action that can always be done. */
  public static Action of(String id, String title, String keys, Runnable run) {
    return new Action(id, title, keys, () -> true, run);
  }
}
