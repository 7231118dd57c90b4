package org.pendant.sweep.plan;

import java.util.List;

/**
 * Plan exception: what is wrong with a plan, for people; carries no stack trace, it is no fault.
 */
public final class PlanException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient List<String> reports;

  /** Several mistakes, each with its place. */
  public PlanException(List<String> reports) {
    super(String.join(System.lineSeparator(), reports), null, false, false);
    this.reports = List.copyOf(reports);
  }

  /** One mistake, with its place. */
  public PlanException(String report) {
    this(List.of(report));
  }

  /** A line or some lines each. */
  public List<String> reports() {
    return reports;
  }
}
