package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

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

  /** Where something was first, and how often. */
  private record Places(int line, String path, int count) {
    Places again() {
      return new Places(line, path, count + 1);
    }

    String with(String message) {
      return count == 1
          ? text("remark", line, path, message)
          : text("remarkSeveral", line, path, message, count);
    }
  }

  void add(XmlElement where, String message) {
    Places before = said.get(message);
    if (before != null) {
      said.put(message, before.again());
    } else if (said.size() < MOST) {
      said.put(message, new Places(where.line(), where.path(), 1));
    }
  }

  List<String> all() {
    List<String> all = new ArrayList<>();
    said.forEach((message, places) -> all.add(places.with(message)));
    return all;
  }
}
