package org.pendant.editors.dap.look;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;

/**
 * Watched signal: a quantity of the robot, or one number of it: {@code digital_in[2]}, {@code
 * tcp_force}.
 *
 * @param quantity that it is of
 * @param index which of its numbers; empty for all
 */
public record WatchedSignal(StateQuantity quantity, OptionalInt index) {
  /** Begins the name by which data breakpoints know one. */
  public static final String WATCHABLE = "signal:";

  private static final Pattern FORM = Pattern.compile("(\\w+)(?:\\[(\\d{1,3})])?");

  /** Reads one; empty for what is none. */
  public static Optional<WatchedSignal> of(String text) {
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      return Optional.empty();
    }
    OptionalInt index =
        form.group(2) == null
            ? OptionalInt.empty()
            : OptionalInt.of(Integer.parseInt(form.group(2)));
    return StateQuantities.all().stream()
        .filter(each -> each.name().equals(form.group(1)))
        .filter(each -> index.orElse(0) < each.size())
        .findFirst()
        .map(each -> new WatchedSignal(each, index));
  }

  /** What it is in a snapshot. */
  public String text(ControllerState state) {
    return index.isPresent()
        ? RobotBranches.text(
            quantity.type(), quantity.getter().element(index.getAsInt()).applyAsDouble(state))
        : Arrays.stream(quantity.numbers(state))
            .mapToObj(number -> RobotBranches.text(quantity.type(), number))
            .collect(Collectors.joining(", "));
  }
}
