package org.pendant.language.service;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.language.signature.Parameter;
import org.pendant.language.source.SourceRange;

/**
 * Call site: one call of a function or method, or one start of a thread.
 *
 * @param callee what is called
 * @param nameRange its name
 * @param range the whole call
 * @param caller offset of the name of the innermost definition around it; empty at the main level
 *     of a text without a program's function
 */
public record CallSite(
    Symbol callee,
    SourceRange nameRange,
    SourceRange range,
    OptionalInt caller,
    List<Given> arguments) {

  /** Copies the arguments. */
  public CallSite {
    arguments = List.copyOf(arguments);
  }

  /**
   * One argument.
   *
   * @param value the expression that is given
   * @param byName whether it is written as {@code name = value}
   * @param parameter what it is given for; empty where that is not known
   */
  public record Given(SourceRange value, boolean byName, Optional<Parameter> parameter) {}
}
