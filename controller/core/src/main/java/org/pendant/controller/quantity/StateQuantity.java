package org.pendant.controller.quantity;

import static org.pendant.controller.quantity.QuantityTexts.text;

import java.util.List;
import java.util.stream.Collectors;
import org.pendant.controller.state.ControllerState;

/**
 * A state quantity: one number of a snapshot, or some that belong together. Poses and what belongs
 * to the TCP are in the base frame.
 *
 * @param name stable name, such as {@code actual_q}
 * @param place where its components stand in lists for people, level by level
 * @param explanationKey key of what it is, where group and titles do not say enough; may be empty
 * @param type of each component
 * @param components at least one
 * @param getter reads them from a snapshot
 * @param rtdeNames RTDE output fields: each has all components, or, where {@code fieldEach}, the
 *     component at its place; an empty name is no field
 * @param fieldEach whether each component is a field of its own
 */
public record StateQuantity(
    String name,
    List<QuantityTitle> place,
    String explanationKey,
    ScalarType type,
    List<Component> components,
    Getter getter,
    List<String> rtdeNames,
    boolean fieldEach) {
  /** Copies the lists. */
  public StateQuantity {
    place = List.copyOf(place);
    components = List.copyOf(components);
    rtdeNames = List.copyOf(rtdeNames);
  }

  /** Where its components stand in lists for people, levels separated by {@code /}. */
  public String group() {
    return place.stream().map(QuantityTitle::text).collect(Collectors.joining("/"));
  }

  /** What it is, where group and titles do not say enough; may be empty. */
  public String explanation() {
    return explanationKey.isEmpty() ? "" : text(explanationKey);
  }

  /** How many components it has. */
  public int size() {
    return components.size();
  }

  /** The numbers in a snapshot, in a new array. */
  public double[] numbers(ControllerState state) {
    double[] numbers = new double[size()];
    getter.read(state, numbers, 0);
    return numbers;
  }

  /** The only number in a snapshot, or the first. */
  public double number(ControllerState state) {
    return getter.element(0).applyAsDouble(state);
  }

  StateQuantity explained(String key) {
    return new StateQuantity(name, place, key, type, components, getter, rtdeNames, fieldEach);
  }

  StateQuantity published(List<String> names, boolean each) {
    return new StateQuantity(name, place, explanationKey, type, components, getter, names, each);
  }
}
