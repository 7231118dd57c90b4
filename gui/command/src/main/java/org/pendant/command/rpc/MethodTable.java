package org.pendant.command.rpc;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.language.check.Nearest;

/** Method table: all methods by name. */
final class MethodTable {
  private final Robots robots;
  private final Map<String, RpcMethod> methods = new LinkedHashMap<>();

  MethodTable(Robots robots) {
    this.robots = robots;
  }

  /** Adds a method that is about no robot, or about all. */
  void add(String name, RpcMethod method) {
    if (methods.putIfAbsent(name, method) != null) {
      throw new IllegalStateException("method " + name + " is declared twice");
    }
  }

  /**
   * Adds a method of a robot.
   *
   * @param keys its parameters, apart from the robot's handle
   */
  void add(String name, List<String> keys, RpcMethod.OfRobot method) {
    add(
        name,
        params -> {
          params.allow(keys.toArray(String[]::new));
          return method.call(robots.of(params), params);
        });
  }

  /** The names of all. */
  List<String> names() {
    return List.copyOf(methods.keySet());
  }

  /** The method called {@code name}. */
  RpcMethod of(String name) throws RpcFailure {
    RpcMethod found = methods.get(name);
    if (found == null) {
      throw new RpcFailure(
          RpcFailure.METHOD_NOT_FOUND,
          Nearest.among(name, names())
              .map(near -> RpcTexts.text("noSuchMethodButNear", shortened(name), near))
              .orElseGet(() -> RpcTexts.text("noSuchMethod", shortened(name))));
    }
    return found;
  }

  private static String shortened(String name) {
    return name.length() > 40 ? name.substring(0, 40) + "..." : name;
  }
}
