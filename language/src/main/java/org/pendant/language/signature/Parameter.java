package org.pendant.language.signature;

import java.util.List;

/**
 * One parameter of a function.
 *
 * @param required whether a call must give it
 * @param defaultText the default as it would be written in a script, or a description in angle
 *     brackets when the default depends on the robot's state; empty when required
 * @param aliases other names that calls may give it by: where the manual contradicts itself, or had
 *     another one once
 */
public record Parameter(
    String name, Type type, Unit unit, boolean required, String defaultText, List<String> aliases) {
  public Parameter {
    aliases = List.copyOf(aliases);
  }

  /** A parameter with one name. */
  public Parameter(String name, Type type, Unit unit, boolean required, String defaultText) {
    this(name, type, unit, required, defaultText, List.of());
  }

  /** One line about it: {@code v: number in rad/s, default 1.05}. */
  public String described() {
    return name
        + ": "
        + type.text()
        + (unit == Unit.NONE ? "" : " in " + unit.symbol())
        + (required ? "" : ", default " + defaultText);
  }

  /** Whether a call may give it as {@code other}. */
  public boolean named(String other) {
    return name.equals(other) || aliases.contains(other);
  }
}
