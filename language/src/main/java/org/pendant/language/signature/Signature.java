package org.pendant.language.signature;

import java.util.List;
import java.util.Optional;

/**
 * Signature: one built-in function or method as a caller sees it.
 *
 * @param module the manual's module: motion, internals, urmath, interfaces, ... or core
 * @param receiver for a method, the kind of value it is called on; empty for a function
 * @param section the manual's section, e.g. {@code 16.54}
 * @param physicalTime whether it may take robot time, so that a secondary program refuses it
 * @param allowedInSecondary whether a secondary program may call it at all
 * @param deprecated the function to use instead; empty when current
 * @param documentation our own words, one sentence first
 */
public record Signature(
    String module,
    Optional<Type> receiver,
    String name,
    List<Parameter> parameters,
    Type result,
    Unit resultUnit,
    String section,
    boolean physicalTime,
    boolean allowedInSecondary,
    String deprecated,
    String documentation) {
  public Signature {
    parameters = List.copyOf(parameters);
  }

  /** How many leading arguments a call cannot do without. */
  public int requiredCount() {
    return (int) parameters.stream().filter(Parameter::required).count();
  }

  /** The head as the manual prints it, e.g. {@code movej(q, a=1.4, v=1.05, t=0, r=0)}. */
  public String head() {
    StringBuilder head = new StringBuilder(name).append('(');
    String separator = "";
    for (Parameter parameter : parameters) {
      head.append(separator).append(parameter.name());
      if (!parameter.required()) {
        head.append('=').append(parameter.defaultText());
      }
      separator = ", ";
    }
    return head.append(')').toString();
  }
}
