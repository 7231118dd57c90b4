package org.pendant.project.program.file;

import java.util.List;

/** Tree file error: a file has no program tree, or one that cannot be read to its end. */
public final class BrokenTree extends Exception {
  private static final long serialVersionUID = 1;

  private final transient List<String> reports;

  BrokenTree(List<String> reports) {
    super(reports.getFirst(), null, false, false);
    this.reports = List.copyOf(reports);
  }

  /** What is wrong, each as compilers say it: {@code pick.pendant:3:7: error: ...}. */
  public List<String> reports() {
    return reports;
  }
}
