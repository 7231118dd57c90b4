package org.pendant.project.program.urp;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.project.polyscope.xml.XmlElement;

/**
 * Remarks: what is to be said about a file that was read; the same is said once, for the first
 * place.
 */
final class Remarks {
  private static final int MOST = 200;

  private final Map<String, Places> said = new LinkedHashMap<>();

  /** Where something was, and how often. */
  private record Places(String first, int count) {}

  void add(XmlElement where, String message) {
    Places before = said.get(message);
    if (before != null) {
      said.put(message, new Places(before.first(), before.count() + 1));
    } else if (said.size() < MOST) {
      said.put(message, new Places("line " + where.line() + ", " + where.path(), 1));
    }
  }

  List<String> all() {
    List<String> all = new ArrayList<>();
    said.forEach(
        (message, places) ->
            all.add(
                places.first()
                    + ": "
                    + message
                    + (places.count() == 1 ? "" : " (" + places.count() + " times)")));
    return all;
  }
}
