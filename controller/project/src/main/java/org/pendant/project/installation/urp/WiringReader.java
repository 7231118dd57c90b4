package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolCommunication.Parity;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.project.polyscope.xml.XmlElement;

/**
 * Wiring reader: takes the domains of analog signals and the tool connector out of the elements
 * about them.
 */
final class WiringReader {
  private static final Wiring USUAL = Wiring.STANDARD;

  private static final Map<String, Integer> VOLTAGES =
      Map.of("ZERO", 0, "TWELVE", 12, "TWENTY_FOUR", 24);

  private final Optional<XmlElement> ios;
  private final Optional<XmlElement> tool;
  private final List<String> remarks;

  WiringReader(Optional<XmlElement> ios, Optional<XmlElement> tool, List<String> remarks) {
    this.ios = ios;
    this.tool = tool;
    this.remarks = remarks;
  }

  Wiring read() {
    // the tool's two inputs stand after those of the box
    List<AnalogDomain> in = domains("analogInputRange", 4);
    List<AnalogDomain> out = domains("analogOutputDomain", 2);
    List<AnalogDomain> toolIn = in.isEmpty() ? USUAL.toolAnalogIn() : in.subList(2, 4);
    return new Wiring(
        in.isEmpty() ? USUAL.analogIn() : in.subList(0, 2),
        out.isEmpty() ? USUAL.analogOut() : out,
        List.of(
            chosen("toolAnalogInput2", AnalogDomain.values(), toolIn.get(0)),
            chosen("toolAnalogInput3", AnalogDomain.values(), toolIn.get(1))),
        voltage(),
        chosen("toolOutputMode", ToolOutputMode.values(), USUAL.toolOutputMode()),
        List.of(
            chosen("toolDigitalOutput0", ToolPinMode.values(), USUAL.toolPins().get(0)),
            chosen("toolDigitalOutput1", ToolPinMode.values(), USUAL.toolPins().get(1))),
        communication());
  }

  /** Domains by their numbers; none if there are not so many. */
  private List<AnalogDomain> domains(String name, int count) {
    String text = ios.flatMap(each -> each.child(name)).map(each -> each.text("value")).orElse("");
    return Arrays.stream(Rows.numbers(text, count))
        .mapToObj(each -> AnalogDomain.of((int) each))
        .toList();
  }

  private String word(String attribute) {
    return tool.map(each -> each.text(attribute)).orElse("");
  }

  /** The constant that an attribute names; the usual one if it is not there. */
  private <E extends Enum<E>> E chosen(String attribute, E[] all, E usual) {
    // two digital outputs
    String word =
        word(attribute).equals("OUTPUT") ? ToolOutputMode.DIGITAL.name() : word(attribute);
    Optional<E> named = Arrays.stream(all).filter(each -> each.name().equals(word)).findFirst();
    if (named.isEmpty() && !word.isEmpty()) {
      notUnderstood(attribute, word, usual.name().toLowerCase(Locale.ROOT));
    }
    return named.orElse(usual);
  }

  private void notUnderstood(String attribute, String word, String usual) {
    remarks.add(text("settingUnknown", attribute, word, usual));
  }

  private int voltage() {
    String word = word("toolOutputVoltage");
    if (!word.isEmpty() && !VOLTAGES.containsKey(word)) {
      notUnderstood("toolOutputVoltage", word, USUAL.toolVoltage() + " V");
    }
    return VOLTAGES.getOrDefault(word, USUAL.toolVoltage());
  }

  private ToolCommunication communication() {
    ToolCommunication usual = USUAL.toolCommunication();
    double[] baud = Rows.numbers(word("baudRate").replace("BAUD_", ""), 1);
    double[] rx = Rows.numbers(word("rxIdleChars"), 1);
    double[] tx = Rows.numbers(word("txIdleChars"), 1);
    if (baud.length + rx.length + tx.length < 3) {
      return usual;
    }
    try {
      return new ToolCommunication(
          word("enabled").equals("true"),
          (int) baud[0],
          chosen("parity", Parity.values(), usual.parity()),
          word("stopBits").equals("TWO") ? 2 : 1,
          (float) rx[0],
          (float) tx[0]);
    } catch (IllegalArgumentException e) {
      remarks.add(text("serialKept", e.getMessage()));
      return usual;
    }
  }
}
