package org.pendant.recording.compare;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.quantity.Component;
import org.pendant.controller.quantity.PhysicalUnit;
import org.pendant.controller.quantity.ScalarType;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;

/**
 * Sampled quantity: a state quantity as recordings call it, which is as RTDE calls it where that
 * knows it.
 */
public final class SampledQuantity {
  static final StateQuantity TARGET_Q = StateQuantities.of("target_q");

  static final StateQuantity TARGET_QD = StateQuantities.of("target_qd");
  static final StateQuantity ACTUAL_Q = StateQuantities.of("actual_q");
  static final StateQuantity ACTUAL_QD = StateQuantities.of("actual_qd");
  static final StateQuantity TCP_OFFSET = StateQuantities.of("tcp_offset");
  static final StateQuantity TARGET_CURRENT = StateQuantities.of("target_current");
  static final StateQuantity CURRENT = StateQuantities.of("current");
  static final StateQuantity SPEED_SLIDER = StateQuantities.of("speed_slider");
  static final StateQuantity PAYLOAD = StateQuantities.of("payload");
  static final StateQuantity PAYLOAD_COG = StateQuantities.of("payload_cog");

  private SampledQuantity() {}

  /** What is worth comparing: measures with a unit, apart from clocks. */
  public static List<StateQuantity> all() {
    return StateQuantities.all().stream().filter(SampledQuantity::isMeasure).toList();
  }

  private static boolean isMeasure(StateQuantity quantity) {
    PhysicalUnit unit = quantity.components().getFirst().unit();
    boolean counts =
        switch (unit) {
          case NONE, LEVEL, SECOND, MILLISECOND, JOULE, AMPERE_OR_VOLT -> false;
          case RATIO,
              METRE,
              METRE_PER_SECOND,
              METRE_PER_SECOND_SQUARED,
              RADIAN,
              RADIAN_PER_SECOND,
              RADIAN_PER_SECOND_SQUARED,
              KILOGRAM,
              KILOGRAM_METRE_SQUARED,
              KILOGRAM_METRE_PER_SECOND,
              NEWTON,
              NEWTON_METRE,
              VOLT,
              AMPERE,
              CELSIUS ->
              true;
        };
    return counts && quantity.type() == ScalarType.DOUBLE;
  }

  /** Its name in tables: that of RTDE, or else its own. */
  public static String name(StateQuantity quantity) {
    if (quantity.fieldEach()) {
      return quantity.name();
    }
    return quantity.rtdeNames().stream()
        .filter(each -> !each.isEmpty())
        .findFirst()
        .orElse(quantity.name());
  }

  /** The name of one of its numbers in tables, such as {@code actual_q_0}. */
  public static String name(StateQuantity quantity, int component) {
    return quantity.size() == 1 ? name(quantity) : name(quantity) + "_" + component;
  }

  /** The symbol of the unit of one of its numbers. */
  public static String unit(StateQuantity quantity, int component) {
    return quantity.components().get(component).unit().symbol();
  }

  /** Whether it is a pose: place and rotation vector. */
  static boolean isPose(StateQuantity quantity) {
    List<Component> components = quantity.components();
    return components.size() == 6
        && components.getFirst().unit() == PhysicalUnit.METRE
        && components.getLast().unit() == PhysicalUnit.RADIAN;
  }

  /** What the joints should do, or else what they do; empty where a recording has neither. */
  static Optional<StateQuantity> speed(Samples samples) {
    return List.of(TARGET_QD, ACTUAL_QD).stream().filter(samples::has).findFirst();
  }
}
