package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.command.Refusal;

/**
 * Input owners: which client alone may write a signal. A client of a port takes the signals it is
 * going to write; others are refused then, with its name. Owned by the frame loop.
 *
 * <p>Signals go by the names of {@link SignalWrite#name}, such as {@code input_float_register[3]};
 * other things that have one writer at a time ({@link #SPEED_SLIDER}) by names of their own.
 */
public final class InputOwners {
  /** The speed slider. */
  public static final String SPEED_SLIDER = "speed_slider";

  /** The writer that owns nothing: a person at the screen. */
  public static final String BY_HAND = "";

  private final Map<String, String> owners = new HashMap<>();

  /**
   * Takes a signal. Taking it twice is no mistake.
   *
   * @return why not, with the name of its owner; empty when it is taken
   */
  public Optional<Refusal> claim(String signal, String owner) {
    Optional<Refusal> refusal = refusal(signal, owner);
    if (refusal.isEmpty()) {
      owners.put(signal, owner);
    }
    return refusal;
  }

  /** Gives back all that {@code owner} has taken. */
  public void release(String owner) {
    owners.values().removeIf(owner::equals);
  }

  /** Who has taken a signal. */
  public Optional<String> owner(String signal) {
    return Optional.ofNullable(owners.get(signal));
  }

  /** Whether {@code writer} may write a signal. */
  public boolean mayWrite(String signal, String writer) {
    String owner = owners.get(signal);
    return owner == null || owner.equals(writer);
  }

  /** Why {@code writer} must not write a signal; empty when it may. */
  public Optional<Refusal> refusal(String signal, String writer) {
    return owner(signal)
        .filter(owner -> !owner.equals(writer))
        .map(owner -> new Refusal(Refusal.Code.IN_USE, text("inUse", signal, owner)));
  }
}
