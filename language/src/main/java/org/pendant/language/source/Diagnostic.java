package org.pendant.language.source;

/**
 * Diagnostic: one complaint about a program, in terms a programmer can act on.
 *
 * @param code stable identifier in kebab-case, e.g. {@code unknown-function}
 * @param severity whether the program may still run
 * @param range where in the source
 * @param message human text: what was found and what would be right
 * @param wireText the controller's own wording for the same fault, as clients of the primary
 *     interface receive it, e.g. {@code compile_error_name_not_found:foo:}; empty when the
 *     controller has none
 */
public record Diagnostic(
    String code, Severity severity, SourceRange range, String message, String wireText) {

  /** Whether a diagnostic keeps the program from running. */
  public enum Severity {
    ERROR,
    WARNING
  }

  public static Diagnostic error(String code, SourceRange range, String message, String wireText) {
    return new Diagnostic(code, Severity.ERROR, range, message, wireText);
  }

  public static Diagnostic warning(String code, SourceRange range, String message) {
    return new Diagnostic(code, Severity.WARNING, range, message, "");
  }

  public boolean isError() {
    return severity == Severity.ERROR;
  }
}
