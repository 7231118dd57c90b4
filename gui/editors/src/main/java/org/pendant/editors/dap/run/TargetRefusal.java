package org.pendant.editors.dap.run;

/** Target refusal: why there is nothing to debug, in words for the user. */
public final class TargetRefusal extends Exception {
  private static final long serialVersionUID = 1;

  /** For a reason, which names file and place where it has one. */
  public TargetRefusal(String reason) {
    super(reason);
  }
}
