package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.ControlHost;
import org.pendant.project.polyscope.xml.XmlElement;

/**
 * Contribution reader: takes what is known of URCaps out of what they keep in an installation:
 * pairs of key and value each.
 */
final class ContributionReader {
  private static final String EXTERNAL_CONTROL = "External Control";

  private final List<XmlElement> urcaps;
  private final List<String> remarks;

  /**
   * @param contributions what all have contributed
   */
  ContributionReader(Optional<XmlElement> contributions, List<String> remarks) {
    urcaps =
        contributions.flatMap(each -> each.child("URCaps")).stream()
            .flatMap(each -> each.children("Contributed").stream())
            .toList();
    this.remarks = remarks;
  }

  /** Where External Control gets its script; tells of all others that keep something. */
  ControlHost controlHost() {
    ControlHost host = ControlHost.STANDARD;
    for (XmlElement each : urcaps) {
      if (each.text("name").equals(EXTERNAL_CONTROL)) {
        host = controlHost(each);
      } else if (!each.children().isEmpty() && !value(each, "enabled").equals("false")) {
        remarks.add(text("urcapUnknown", each.text("name")));
      }
    }
    return host;
  }

  private ControlHost controlHost(XmlElement urcap) {
    String host = value(urcap, "host_ip");
    String port = value(urcap, "port_nr");
    try {
      ControlHost read =
          new ControlHost(
              host.isEmpty() ? ControlHost.STANDARD.host() : host,
              port.isEmpty() ? ControlHost.STANDARD.port() : Integer.parseInt(port));
      Optional<String> problem = read.problem();
      if (problem.isEmpty()) {
        return read;
      }
      tellBroken(urcap, problem.get());
    } catch (NumberFormatException e) {
      tellBroken(urcap, text("portNoNumber", port));
    }
    return ControlHost.STANDARD;
  }

  private void tellBroken(XmlElement urcap, String why) {
    remarks.add(
        text("atLine", urcap.line(), text("controlKept", ControlHost.STANDARD.text(), why)));
  }

  private static String value(XmlElement urcap, String key) {
    return urcap.children("data").stream()
        .filter(each -> each.text("key").equals(key))
        .findFirst()
        .map(each -> each.text("value").strip())
        .orElse("");
  }
}
