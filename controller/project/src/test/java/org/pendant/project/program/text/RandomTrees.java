package org.pendant.project.program.text;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;
import org.pendant.project.program.WaypointPosition;

/** Trees of every kind of node with anything in their fields. */
public final class RandomTrees {
  private static final String CHARACTERS =
      "abc XYZ 019_-+=[]{}()#|>\"'\\\n\r\t\u0000\u0007\u00e9\u2260\u2028\u4e2d\ud83d\ude00,.;:/&<%";

  private final Random random;

  public RandomTrees(long seed) {
    random = new Random(seed);
  }

  public ProgramTree tree() {
    Map<String, WaypointPosition> waypoints = new LinkedHashMap<>();
    for (int i = random.nextInt(4); i > 0; i--) {
      waypoints.put("w" + i + text(), new WaypointPosition(pose(), text(), joints(), pose()));
    }
    List<ProgramNode> sections = new ArrayList<>();
    sections.add(node(new Section.MainProgram(random.nextBoolean()), 3));
    for (int i = random.nextInt(3); i > 0; i--) {
      sections.add(node(new Section.SubProgram(text(), text()), 2));
    }
    sections.add(0, node(make(Section.InitialValues.class), 0));
    return new ProgramTree(text(), waypoints, List.of(), 1).insert(ProgramTree.ROOT, 0, sections);
  }

  private ProgramNode node(Step step, int deep) {
    List<ProgramNode> children = new ArrayList<>();
    for (int i = deep == 0 ? 0 : random.nextInt(5); i > 0; i--) {
      children.add(node(anyStep(), deep - 1));
    }
    return new ProgramNode(0, step, random.nextInt(5) == 0, children);
  }

  private Step anyStep() {
    List<Class<? extends Record>> all = Forms.leaves(Step.class).toList();
    return all.isEmpty() ? new FlowStep.Else() : make(all.get(random.nextInt(all.size())));
  }

  /** A step of a kind, with anything in its fields. */
  Step make(Class<? extends Record> type) {
    return (Step) record(type);
  }

  private Record record(Class<? extends Record> type) {
    RecordComponent[] components = type.getRecordComponents();
    Object[] values = new Object[components.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = value(components[i].getType(), components[i].getGenericType());
    }
    return Components.make(type, values);
  }

  private Object value(Class<?> type, Type generic) {
    if (type == double.class || type == Double.class) {
      return number();
    }
    if (type == int.class) {
      return random.nextInt(2_000_000) - 1_000_000;
    }
    if (type == boolean.class || type == Boolean.class) {
      return random.nextBoolean();
    }
    if (type == String.class) {
      return text();
    }
    if (type == OptionalDouble.class) {
      return random.nextBoolean() ? OptionalDouble.of(number()) : OptionalDouble.empty();
    }
    if (type == Pose.class) {
      return pose();
    }
    if (type == Joints.class) {
      return joints();
    }
    if (type == List.class) {
      Class<?> of = (Class<?>) ((ParameterizedType) generic).getActualTypeArguments()[0];
      List<Object> list = new ArrayList<>();
      for (int i = random.nextInt(4); i > 0; i--) {
        list.add(value(of, of));
      }
      return list;
    }
    if (type.isEnum()) {
      return type.getEnumConstants()[random.nextInt(type.getEnumConstants().length)];
    }
    if (type.isSealed()) {
      List<Class<? extends Record>> variants = Forms.leaves(type).toList();
      return record(variants.get(random.nextInt(variants.size())));
    }
    return record(type.asSubclass(Record.class));
  }

  private double number() {
    return switch (random.nextInt(4)) {
      case 0 -> random.nextInt(100);
      case 1 -> -0.0;
      case 2 -> random.nextGaussian() * Math.pow(10, random.nextInt(40) - 20);
      default -> random.nextDouble();
    };
  }

  private Pose pose() {
    return Pose.of(random.doubles(6, -3, 3).toArray());
  }

  private Joints joints() {
    return Joints.of(random.doubles(6, -6, 6).toArray());
  }

  private String text() {
    StringBuilder text = new StringBuilder();
    for (int i = random.nextInt(12); i > 0; i--) {
      text.append(CHARACTERS.charAt(random.nextInt(CHARACTERS.length())));
    }
    return text.toString();
  }
}
