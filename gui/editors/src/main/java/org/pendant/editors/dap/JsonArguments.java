package org.pendant.editors.dap;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;

/**
 * JSON arguments: an object of a request whose members the protocol leaves open, with messages for
 * who wrote them.
 */
final class JsonArguments {
  /** Elements of a list that are read. */
  private static final int MOST = 1000;

  private final Map<String, Object> members;

  JsonArguments(Map<String, Object> told) {
    members = told;
  }

  private Optional<Object> get(String name) {
    return Optional.ofNullable(members.get(name));
  }

  private static IllegalArgumentException wrong(String name, Object found, String expected) {
    return new IllegalArgumentException(
        DebugAdapterTexts.text("wrongArgument", name, found, expected));
  }

  /** A text that is not empty; an empty one counts as missing. */
  Optional<String> text(String name) {
    Optional<Object> found = get(name);
    found
        .filter(each -> !(each instanceof String))
        .ifPresent(
            each -> {
              throw wrong(name, each, DebugAdapterTexts.text("aText"));
            });
    return found.map(String.class::cast).filter(each -> !each.isBlank());
  }

  /** A text or a number, as text. */
  Optional<String> scalar(String name) {
    return get(name).map(each -> scalar(name, each));
  }

  private static String scalar(String name, Object found) {
    return switch (Objects.requireNonNullElse(found, "")) {
      case String text -> text;
      case Boolean flag -> flag.toString();
      case Number number when number.doubleValue() == number.longValue() ->
          String.valueOf(number.longValue());
      case Number number -> number.toString();
      default -> throw wrong(name, found, DebugAdapterTexts.text("anyScalar"));
    };
  }

  boolean flag(String name) {
    return get(name)
        .map(
            each -> {
              if (each instanceof Boolean flag) {
                return flag;
              }
              throw wrong(name, each, DebugAdapterTexts.text("trueOrFalse"));
            })
        .orElse(false);
  }

  /** A list of texts. */
  List<String> texts(String name) {
    Optional<Object> found = get(name);
    if (found.isEmpty()) {
      return List.of();
    }
    if (!(found.get() instanceof List<?> list) || list.size() > MOST) {
      throw wrong(name, found.get(), DebugAdapterTexts.text("listOfTexts"));
    }
    return list.stream().map(each -> scalar(name, each)).toList();
  }

  /** The members of an object as {@code name=value}, or a list of such texts. */
  List<String> pairs(String name) {
    Optional<Object> found = get(name);
    if (found.isPresent() && found.get() instanceof Map<?, ?> map && map.size() <= MOST) {
      Map<String, String> sorted = new TreeMap<>();
      map.forEach(
          (key, value) -> {
            String member = String.valueOf(key);
            sorted.put(member, scalar(name + "." + member, value));
          });
      List<String> pairs = new ArrayList<>();
      sorted.forEach((key, value) -> pairs.add(key + "=" + value));
      return pairs;
    }
    return texts(name);
  }
}
