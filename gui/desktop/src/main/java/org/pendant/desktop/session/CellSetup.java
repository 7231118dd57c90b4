package org.pendant.desktop.session;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellPlan;

/**
 * Cell setup: how several controllers that share a cell are switched on.
 *
 * @param plan of the cell
 * @param options of each controller, in the order of {@link
 *     org.pendant.controller.layout.CellLayout#names}
 */
public record CellSetup(CellPlan plan, List<ControllerOptions> options) {
  /** The list is copied. */
  public CellSetup {
    options = List.copyOf(options);
  }

  /** The same with each controller switched on otherwise. */
  CellSetup with(UnaryOperator<ControllerOptions> change) {
    return with((name, each) -> change.apply(each));
  }

  /** As the other one, with the name of each controller. */
  public CellSetup with(BiFunction<String, ControllerOptions, ControllerOptions> change) {
    List<String> names = plan.layout().names();
    return new CellSetup(
        plan,
        IntStream.range(0, options.size())
            .mapToObj(i -> change.apply(names.get(i), options.get(i)))
            .toList());
  }
}
