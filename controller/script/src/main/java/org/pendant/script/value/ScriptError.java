package org.pendant.script.value;

/**
 * Script error: a running program did something that cannot be done. The machine adds where; the
 * program stops.
 *
 * <p>Carries no Java stack trace: it describes the script, not this code.
 */
public final class ScriptError extends Exception {
  private static final long serialVersionUID = 1L;
  private final String code;

  /**
   * @param code stable kebab-case identifier, e.g. {@code index-out-of-range}
   * @param message what, the value, what was expected
   */
  public ScriptError(String code, String message) {
    super(message, null, false, false);
    this.code = code;
  }

  public String code() {
    return code;
  }
}
