package org.pendant.kit.action;

import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Action: something that people can do.
 *
 * @param id stable name in settings, such as {@code program.run}
 * @param title what menus and palette show, such as {@code Run program}; what is on or off is
 *     called as it is when it is on, such as {@code Noise of sensors}
 * @param keys the key as {@link javax.swing.KeyStroke#getKeyStroke(String)} reads it, such as
 *     {@code F5} or {@code control shift P}; empty for none
 * @param enabled whether it can be done now
 * @param run does it, on the dispatch thread
 * @param mark whether it has something on or off; nothing for one that is just done
 * @param words by which people look for it beside those of the title; empty for none
 */
public record Action(
    String id,
    String title,
    String keys,
    BooleanSupplier enabled,
    Runnable run,
    Optional<Mark> mark,
    String words) {

  /** How an action that has something on or off is marked. */
  public sealed interface Mark {
    /** Whether it is on now. */
    BooleanSupplier on();

    /** On or off by itself; doing the action turns it over. */
    record Check(BooleanSupplier on) implements Mark {}

    /** One of several of which one is on; doing the action chooses it. */
    record Choice(BooleanSupplier on) implements Mark {}
  }

  /** An action that is just done. */
  public Action(String id, String title, String keys, BooleanSupplier enabled, Runnable run) {
    this(id, title, keys, enabled, run, Optional.empty(), "");
  }

  /** An action that can always be done. */
  public static Action of(String id, String title, String keys, Runnable run) {
    return new Action(id, title, keys, () -> true, run);
  }

  /** This one, which turns over what is {@code on} or off. */
  public Action checked(BooleanSupplier on) {
    return new Action(id, title, keys, enabled, run, Optional.of(new Mark.Check(on)), words);
  }

  /** This one, which chooses one of several; {@code on} says whether it is the chosen one. */
  public Action chosen(BooleanSupplier on) {
    return new Action(id, title, keys, enabled, run, Optional.of(new Mark.Choice(on)), words);
  }

  /** This one, which people find by other words as well. */
  public Action foundBy(String others) {
    return new Action(id, title, keys, enabled, run, mark, others);
  }

  /** All by which it is found. */
  public String found() {
    return words.isEmpty() ? title : title + ", " + words;
  }
}
