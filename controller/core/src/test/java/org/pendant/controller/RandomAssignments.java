package org.pendant.controller;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * Makes up programs that assign, change, pass and copy parts of nested values, and does the same
 * itself in the most simple way: every assignment copies everything. Lists and structs are Java's,
 * an {@code Integer} is an int.
 */
final class RandomAssignments {
  /** So many that copies share them, as they share the lists of 40. */
  private static final int STRUCTS = 70;

  /** The types that values have, each made of the ones before it. */
  private enum Shape {
    INT,
    INTS,
    INNER,
    OUTER,
    MANY,
    WHOLE
  }

  /** A place in a variable. */
  private record Place(String text, Shape shape, Object value, Setter setter) {}

  private interface Setter {
    void set(Object value);
  }

  private final Random random;
  private final Map<String, Object> variables = new LinkedHashMap<>();
  private final List<String> expected = new ArrayList<>();
  private final StringBuilder text = new StringBuilder();

  RandomAssignments(Random random) {
    this.random = random;
  }

  /** What the program sends. */
  List<String> expected() {
    return expected;
  }

  /** A program of {@code statements} random statements. */
  String program(int statements) {
    text.append(
        """
        def prog():
          def inner(n):
            return struct(m=make_list(30, n, 40), k=n)
          end
          def outer(n):
            return struct(n=n, l=make_list(33, n, 40), t=inner(n))
          end
          def changed(s):
            s.n = s.n + 1
            s.l[0] = s.n
            s.t.m[1] = 5
            s.t.m.append(6)
            s.t.m.pop()
            return s
          end
        """);
    for (String name : List.of("a", "b", "c")) {
      int n = variables.size();
      text.append("  ").append(name).append("s = outer(").append(n).append(")\n");
      variables.put(name + "s", outer(n));
      text.append("  ").append(name).append("w = struct(many=make_list(");
      text.append(STRUCTS).append(", outer(").append(n).append(")), one=outer(9))\n");
      variables.put(name + "w", whole(n));
      text.append("  ").append(name).append("i = inner(").append(n).append(")\n");
      variables.put(name + "i", inner(n));
    }
    for (int i = 0; i < statements; i++) {
      statement();
    }
    variables.keySet().forEach(this::show);
    return text.append("end\n").toString();
  }

  private static Object inner(int n) {
    Map<String, Object> inner = new LinkedHashMap<>();
    inner.put("m", ints(30, n));
    inner.put("k", n);
    return inner;
  }

  private static Object outer(int n) {
    Map<String, Object> outer = new LinkedHashMap<>();
    outer.put("n", n);
    outer.put("l", ints(33, n));
    outer.put("t", inner(n));
    return outer;
  }

  private static Object whole(int n) {
    List<Object> many = new ArrayList<>();
    for (int i = 0; i < STRUCTS; i++) {
      many.add(outer(n));
    }
    Map<String, Object> whole = new LinkedHashMap<>();
    whole.put("many", many);
    whole.put("one", outer(9));
    return whole;
  }

  private static List<Object> ints(int count, int n) {
    List<Object> ints = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      ints.add(n);
    }
    return ints;
  }

  private void statement() {
    Place target = place();
    switch (random.nextInt(8)) {
      case 0 -> show(List.copyOf(variables.keySet()).get(random.nextInt(variables.size())));
      case 1 -> change(target);
      default -> assign(target);
    }
  }

  private void line(String statement) {
    text.append("  ").append(statement).append('\n');
  }

  private void show(String variable) {
    line("textmsg(" + variable + ")");
    expected.add(printed(variables.get(variable)));
  }

  private void assign(Place target) {
    if (target.shape() == Shape.INT) {
      int number = random.nextInt(1000);
      line(target.text() + " = " + number);
      target.setter().set(number);
      return;
    }
    Place source = place(target.shape());
    Object value = copy(source.value());
    if (target.shape() == Shape.OUTER && random.nextInt(3) == 0) {
      line(target.text() + " = changed(" + source.text() + ")");
      changed(value);
    } else {
      line(target.text() + " = " + source.text());
    }
    target.setter().set(value);
  }

  /** What the function of this name does with its own copy. */
  @SuppressWarnings("unchecked") // an outer struct has these members
  private static void changed(Object value) {
    Map<String, Object> outer = (Map<String, Object>) value;
    int n = (Integer) outer.get("n") + 1;
    outer.put("n", n);
    List<Object> list = (List<Object>) outer.get("l");
    list.set(0, n);
    ((List<Object>) ((Map<String, Object>) outer.get("t")).get("m")).set(1, 5);
  }

  /** Changes a list by a method; its length stays, so that every index is one. */
  @SuppressWarnings("unchecked") // that is what the shapes tell
  private void change(Place target) {
    if (target.shape() == Shape.INTS) {
      List<Object> list = (List<Object>) target.value();
      int number = random.nextInt(1000);
      line(target.text() + ".insert(1, " + number + ")");
      line(target.text() + ".pop()");
      list.add(1, number);
      list.removeLast();
    } else if (target.shape() == Shape.MANY) {
      List<Object> list = (List<Object>) target.value();
      Place source = place(Shape.OUTER);
      // the list is full
      Object added = copy(source.value());
      line(target.text() + ".pop()");
      list.removeLast();
      line(target.text() + ".append(" + source.text() + ")");
      if (inLast(target, source)) {
        throw new IllegalStateException("the source was removed");
      }
      list.add(added);
    }
  }

  /** Whether {@code source} stood in the last element of {@code list}. */
  private static boolean inLast(Place list, Place source) {
    return source.text().startsWith(list.text() + "[" + (STRUCTS - 1) + "]");
  }

  private Place place(Shape shape) {
    while (true) {
      Place place = place();
      if (place.shape() == shape && !place.text().contains("[" + (STRUCTS - 1) + "]")) {
        return place;
      }
    }
  }

  private Place place() {
    List<String> names = List.copyOf(variables.keySet());
    String name = names.get(random.nextInt(names.size()));
    Shape shape = name.endsWith("w") ? Shape.WHOLE : name.endsWith("s") ? Shape.OUTER : Shape.INNER;
    Object value = variables.get(name);
    Place place = new Place(name, shape, value, v -> variables.put(name, v));
    int depth = random.nextInt(6);
    for (int i = 0; i < depth && place.shape() != Shape.INT; i++) {
      place = inside(place);
    }
    return place;
  }

  @SuppressWarnings("unchecked") // that is what the shapes tell
  private Place inside(Place place) {
    return switch (place.shape()) {
      case INT -> place;
      case INTS -> element(place, Shape.INT);
      case MANY -> element(place, Shape.OUTER);
      case INNER -> member(place, random.nextBoolean() ? "m" : "k");
      case OUTER -> member(place, List.of("n", "l", "t").get(random.nextInt(3)));
      case WHOLE -> member(place, random.nextBoolean() ? "many" : "one");
    };
  }

  @SuppressWarnings("unchecked") // that is what the shapes tell
  private Place element(Place place, Shape shape) {
    List<Object> list = (List<Object>) place.value();
    // mostly the same few, so that what was shared is met again
    int index = random.nextInt(random.nextBoolean() ? 2 : list.size());
    return new Place(
        place.text() + "[" + index + "]", shape, list.get(index), v -> list.set(index, v));
  }

  @SuppressWarnings("unchecked") // that is what the shapes tell
  private static Place member(Place place, String name) {
    Map<String, Object> struct = (Map<String, Object>) place.value();
    Shape shape =
        switch (name) {
          case "n", "k" -> Shape.INT;
          case "l", "m" -> Shape.INTS;
          case "t" -> Shape.INNER;
          case "many" -> Shape.MANY;
          default -> Shape.OUTER;
        };
    return new Place(place.text() + "." + name, shape, struct.get(name), v -> struct.put(name, v));
  }

  private static Object copy(Object value) {
    if (value instanceof List<?> list) {
      return list.stream()
          .map(RandomAssignments::copy)
          .collect(Collectors.toCollection(ArrayList::new));
    }
    if (value instanceof Map<?, ?> struct) {
      Map<Object, Object> copy = new LinkedHashMap<>();
      struct.forEach((name, member) -> copy.put(name, copy(member)));
      return copy;
    }
    return value;
  }

  private static String printed(Object value) {
    if (value instanceof List<?> list) {
      return list.stream()
          .map(RandomAssignments::printed)
          .collect(Collectors.joining(", ", "[", "]"));
    }
    if (value instanceof Map<?, ?> struct) {
      return struct.entrySet().stream()
          .map(member -> member.getKey() + " = " + printed(member.getValue()))
          .collect(Collectors.joining(", ", "{", "}"));
    }
    return value.toString();
  }
}
