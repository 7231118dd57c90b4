package org.pendant.project.program.urp;

import java.util.Optional;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.WaypointPosition;

/** Feature names: what features are called in PolyScope and in Pendant. */
final class Features {
  /** What the base is called in files. */
  static final String BASE = "Joint_0_name";

  /** What the tool is called in files. */
  static final String TOOL = "Joint_6_name";

  private Features() {}

  static String here(String name) {
    return switch (name) {
      case BASE -> WaypointPosition.BASE;
      case TOOL -> WaypointPosition.TOOL;
      default -> name;
    };
  }

  static String there(String name) {
    return switch (name) {
      case WaypointPosition.BASE -> BASE;
      case WaypointPosition.TOOL -> TOOL;
      default -> name;
    };
  }

  /** Our name of the feature that an element is about; the base if it names none. */
  static String in(XmlElement element, ExpressionReader expressions) throws UnreadableFile {
    Optional<XmlElement> feature = element.child("feature");
    String name = feature.isEmpty() ? BASE : expressions.name(feature.get());
    return name.isEmpty() ? WaypointPosition.BASE : here(name);
  }
}
