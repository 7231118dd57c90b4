package org.pendant.editors.lsp.provider;

/** Hint settings: which inlay hints are wanted. */
public record HintSettings(
    boolean parameterNames, boolean units, boolean poses, boolean durations) {
  /** All of them. */
  public static final HintSettings ALL = new HintSettings(true, true, true, true);
}
