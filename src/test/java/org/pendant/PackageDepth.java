package org.pendant;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** Longest chains of packages that use one another, within each module. */
final class PackageDepth {
  private final Map<String, Set<String>> usedBy = new TreeMap<>();
  private final Map<String, List<String>> chains = new HashMap<>();

  PackageDepth(JavaClasses all) {
    for (JavaClass each : all) {
      String user = each.getPackageName();
      Set<String> used = usedBy.computeIfAbsent(user, name -> new TreeSet<>());
      for (Dependency dependency : each.getDirectDependenciesFromSelf()) {
        String name = dependency.getTargetClass().getPackageName();
        if (!name.equals(user) && module(name).equals(module(user))) {
          used.add(name);
        }
      }
    }
  }

  /** The longest chain of each module, by its name, from the top; packages form no cycle. */
  Map<String, List<String>> deepestChains() {
    Map<String, List<String>> deepest = new TreeMap<>();
    for (String each : usedBy.keySet()) {
      List<String> chain = chain(each);
      deepest.merge(module(each), chain, PackageDepth::longer);
    }
    return deepest;
  }

  private List<String> chain(String name) {
    List<String> known = chains.get(name);
    if (known != null) {
      return known;
    }
    List<String> below = List.of();
    for (String each : usedBy.getOrDefault(name, Set.of())) {
      below = longer(below, chain(each));
    }
    List<String> chain = new ArrayList<>(List.of(name));
    chain.addAll(below);
    chains.put(name, chain);
    return chain;
  }

  private static List<String> longer(List<String> one, List<String> other) {
    return other.size() > one.size() ? other : one;
  }

  /** {@code org.pendant.} and one name more. */
  private static String module(String packageName) {
    String[] names = packageName.split("\\.", 4);
    return names.length < 3 ? packageName : String.join(".", names[0], names[1], names[2]);
  }
}
