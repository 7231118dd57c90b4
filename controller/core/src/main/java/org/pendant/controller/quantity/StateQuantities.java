package org.pendant.controller.quantity;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The catalogue: every state quantity, by topic. A new one is an entry in the class of its topic;
 * RTDE, charts and what else takes all of them then have it.
 */
public final class StateQuantities {
  private static final Map<String, StateQuantity> BY_NAME = catalogue();

  private StateQuantities() {}

  private static Map<String, StateQuantity> catalogue() {
    QuantityList list = new QuantityList();
    JointQuantities.declareIn(list);
    ToolQuantities.declareIn(list);
    LoadQuantities.declareIn(list);
    StatusQuantities.declareIn(list);
    SignalQuantities.declareIn(list);
    Map<String, StateQuantity> byName = new LinkedHashMap<>();
    for (StateQuantity each : list.all()) {
      if (byName.putIfAbsent(each.name(), each) != null) {
        throw new IllegalStateException("quantity " + each.name() + " is declared twice");
      }
    }
    return Collections.unmodifiableMap(byName);
  }

  /** All of them. */
  public static List<StateQuantity> all() {
    return List.copyOf(BY_NAME.values());
  }

  /**
   * The one called {@code name}, such as {@code actual_q}.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static StateQuantity of(String name) {
    StateQuantity found = BY_NAME.get(name);
    if (found == null) {
      throw new IllegalArgumentException("there is no state quantity " + name);
    }
    return found;
  }
}
