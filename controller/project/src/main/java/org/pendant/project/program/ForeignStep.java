package org.pendant.project.program;

import java.util.List;

/** Foreign node, which Pendant does not know; it is kept as it was. */
public sealed interface ForeignStep extends Step {

  /**
   * A node of a URCap.
   *
   * @param source who made it
   * @param type of the node there
   * @param data as it was read
   * @param stub URScript that runs in its place; empty for none
   */
  record Contributed(String source, String type, List<String> data, List<String> stub)
      implements ForeignStep {
    public Contributed {
      data = List.copyOf(data);
      stub = List.copyOf(stub);
    }
  }

  /**
   * Any other element of a file that was imported.
   *
   * @param element its name
   * @param data as it was read
   */
  record Unknown(String element, List<String> data) implements ForeignStep {
    public Unknown {
      data = List.copyOf(data);
    }
  }
}
