package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.ForeignStep;

/** Preserved elements: keeps elements to the letter that Pendant does not know. */
final class PreservedElements {
  /** Begins a comment before a contributed node: the script in its place. */
  static final String STUB = "pendant-stub ";

  private PreservedElements() {}

  /** A node that is not known. */
  static ForeignStep.Unknown unknown(XmlElement element, Remarks remarks) {
    element.seeAll();
    String kind = SwitchedOff.kind(element);
    remarks.add(element, text("kept", kind));
    return new ForeignStep.Unknown(kind, List.of(SwitchedOff.plain(element).split("\n", -1)));
  }

  /** A node of a URCap. */
  static ForeignStep.Contributed contributed(XmlElement element, Remarks remarks) {
    element.seeAll();
    String source =
        element
            .attribute("strategyURCapDeveloper")
            .or(() -> element.attribute("strategyURCapName"))
            .or(() -> element.attribute("strategyClass"))
            .orElse("");
    String type = element.text("strategyProgramNodeType");
    List<String> stub = stub(element.comment());
    ForeignStep.Contributed step =
        new ForeignStep.Contributed(
            source, type, List.of(SwitchedOff.plain(element).split("\n", -1)), stub);
    if (stub.isEmpty() && !ExternalControl.is(step)) {
      remarks.add(element, text("urcapKept", type));
    }
    return step;
  }

  private static List<String> stub(String comment) {
    if (!comment.startsWith(STUB)) {
      return List.of();
    }
    try {
      byte[] bytes = Base64.getDecoder().decode(comment.substring(STUB.length()).strip());
      return List.of(new String(bytes, StandardCharsets.UTF_8).split("\n", -1));
    } catch (IllegalArgumentException e) {
      // a comment of another author
      return List.of();
    }
  }
}
