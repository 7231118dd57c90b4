package org.pendant.controller.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Problem list: collects what is wrong. */
final class ProblemList {
  private final List<InstallationProblem> found = new ArrayList<>();

  void add(String field, String message) {
    found.add(new InstallationProblem(field, message, true));
  }

  /** Adds something that is not finished. */
  void remark(String field, String message) {
    found.add(new InstallationProblem(field, message, false));
  }

  /** Adds a problem unless something is right. */
  void require(boolean right, String field, Supplier<String> message) {
    if (!right) {
      add(field, message.get());
    }
  }

  List<InstallationProblem> all() {
    return List.copyOf(found);
  }
}
