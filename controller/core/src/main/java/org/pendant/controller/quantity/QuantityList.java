package org.pendant.controller.quantity;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * A list of declarations. Each declares a quantity by its name, its group and, for a single number,
 * the key of its title; what follows in the chain belongs to the quantity before.
 */
final class QuantityList {
  private static final List<String> JOINTS =
      List.of("base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3");
  private static final List<String> AXES = List.of("x", "y", "z", "rx", "ry", "rz");

  private final List<StateQuantity> quantities = new ArrayList<>();
  private List<QuantityTitle> group = List.of();

  List<StateQuantity> all() {
    return List.copyOf(quantities);
  }

  /**
   * What follows is in this group; that of several numbers in one below it, by its title.
   *
   * @param keys of its titles, level by level
   */
  void group(String... keys) {
    group = Arrays.stream(keys).map(QuantityTitle::of).toList();
  }

  /** Numbers of one type. */
  QuantityList add(
      String name, String title, ScalarType type, List<Component> components, Getter getter) {
    List<QuantityTitle> below = new ArrayList<>(group);
    below.add(QuantityTitle.of(title));
    return in(below, name, type, components, getter);
  }

  private QuantityList in(
      List<QuantityTitle> place,
      String name,
      ScalarType type,
      List<Component> components,
      Getter getter) {
    quantities.add(new StateQuantity(name, place, "", type, components, getter, List.of(), false));
    return this;
  }

  /** What the last one is, where its titles do not say enough. */
  QuantityList explained(String key) {
    quantities.add(quantities.removeLast().explained(key));
    return this;
  }

  /** RTDE fields with the whole of the last one. */
  QuantityList rtde(String... names) {
    quantities.add(quantities.removeLast().published(List.of(names), false));
    return this;
  }

  /** An RTDE field for each component of the last one; an empty name for none. */
  QuantityList rtdeEach(IntFunction<String> name) {
    StateQuantity last = quantities.removeLast();
    quantities.add(last.published(IntStream.range(0, last.size()).mapToObj(name).toList(), true));
    return this;
  }

  QuantityList number(
      String name, String title, PhysicalUnit unit, ToDoubleFunction<ControllerState> value) {
    return scalar(name, title, ScalarType.DOUBLE, unit, value);
  }

  /** A count, a code or bits. */
  QuantityList whole(
      String name, String title, ScalarType type, ToDoubleFunction<ControllerState> value) {
    return scalar(name, title, type, PhysicalUnit.NONE, value);
  }

  /** 0 or 1. */
  QuantityList flag(String name, String title, ToDoubleFunction<ControllerState> value) {
    return scalar(name, title, ScalarType.BOOL, PhysicalUnit.LEVEL, value);
  }

  QuantityList scalar(
      String name,
      String title,
      ScalarType type,
      PhysicalUnit unit,
      ToDoubleFunction<ControllerState> value) {
    List<Component> component = List.of(new Component(name, QuantityTitle.of(title), unit));
    return in(group, name, type, component, new Getter.OfScalars(List.of(value)));
  }

  QuantityList joints(
      String name, String title, PhysicalUnit unit, Function<ControllerState, Joints> value) {
    return joints(name, title, ScalarType.DOUBLE, unit, new Getter.OfJoints(value));
  }

  /** A number for each joint that has to be looked up by itself. */
  QuantityList joints(
      String name, String title, ScalarType type, PhysicalUnit unit, Getter.OfIndex value) {
    return joints(name, title, type, unit, new Getter.OfEach(Joints.COUNT, value));
  }

  private QuantityList joints(
      String name, String title, ScalarType type, PhysicalUnit unit, Getter getter) {
    return add(
        name,
        title,
        type,
        numbered(name, Joints.COUNT, i -> QuantityTitle.of(JOINTS.get(i)), unit),
        getter);
  }

  /** Components that are called by numbers. */
  static List<Component> numbered(
      String name, int count, IntFunction<QuantityTitle> title, PhysicalUnit unit) {
    return IntStream.range(0, count)
        .mapToObj(i -> new Component(name + "_" + i, title.apply(i), unit))
        .toList();
  }

  QuantityList pose(String name, String title, Function<ControllerState, Pose> value) {
    return spatial(name, name, title, PhysicalUnit.METRE, PhysicalUnit.RADIAN, value);
  }

  /**
   * Speed along and about the axes.
   *
   * @param stem begins the names of the components
   */
  QuantityList velocity(
      String name, String stem, String title, Function<ControllerState, Pose> value) {
    return spatial(
        name, stem, title, PhysicalUnit.METRE_PER_SECOND, PhysicalUnit.RADIAN_PER_SECOND, value);
  }

  QuantityList acceleration(String name, String title, Function<ControllerState, Pose> value) {
    return spatial(
        name,
        name,
        title,
        PhysicalUnit.METRE_PER_SECOND_SQUARED,
        PhysicalUnit.RADIAN_PER_SECOND_SQUARED,
        value);
  }

  private QuantityList spatial(
      String name,
      String stem,
      String title,
      PhysicalUnit along,
      PhysicalUnit about,
      Function<ControllerState, Pose> value) {
    List<Component> components =
        IntStream.range(0, Pose.SIZE)
            .mapToObj(
                i ->
                    new Component(
                        stem + "_" + AXES.get(i),
                        QuantityTitle.named(AXES.get(i)),
                        i < 3 ? along : about))
            .toList();
    return add(name, title, ScalarType.DOUBLE, components, new Getter.OfPose(value));
  }

  /**
   * Forces and torques.
   *
   * @param stem begins the names of the components
   */
  QuantityList wrench(
      String name, String stem, String title, Function<ControllerState, Wrench> value) {
    List<Component> components = new ArrayList<>();
    for (String axis : AXES.subList(0, 3)) {
      components.add(
          new Component(stem + "_force_" + axis, QuantityTitle.named(axis), PhysicalUnit.NEWTON));
    }
    for (String axis : AXES.subList(0, 3)) {
      components.add(
          new Component(
              stem + "_torque_" + axis,
              QuantityTitle.of("torqueAbout", axis),
              PhysicalUnit.NEWTON_METRE));
    }
    return add(name, title, ScalarType.DOUBLE, components, new Getter.OfWrench(value));
  }

  /**
   * Numbers along axes.
   *
   * @param axes such as {@code x y z}
   */
  QuantityList axes(
      String name,
      String title,
      String axes,
      PhysicalUnit unit,
      List<ToDoubleFunction<ControllerState>> values) {
    List<Component> components =
        Arrays.stream(axes.split(" "))
            .map(axis -> new Component(name + "_" + axis, QuantityTitle.named(axis), unit))
            .toList();
    return add(name, title, ScalarType.DOUBLE, components, new Getter.OfScalars(values));
  }
}
