package org.pendant.command.doctor;

import static org.pendant.command.doctor.DoctorTexts.text;

import java.io.IOException;
import java.util.List;
import org.pendant.protocols.toolserial.SerialDevices;

/** Looks which serial devices there are for the tool connector, and whether they may be used. */
final class SerialInspection implements Inspection {
  private static final FindingText SUBJECT = text("serial");

  @Override
  public List<Finding> findings() {
    try {
      List<SerialDevices.Found> devices = SerialDevices.all();
      return devices.isEmpty()
          ? List.of(Finding.ok(SUBJECT, text("noDevices")))
          : devices.stream().map(SerialInspection::finding).toList();
    } catch (IOException e) {
      return List.of(
          Finding.note(
              SUBJECT, FindingText.message(e.getMessage()), text("toolSerialDoesNotWork")));
    }
  }

  private static Finding finding(SerialDevices.Found device) {
    return device.permitted()
        ? Finding.ok(SUBJECT, FindingText.of(device.name() + ", " + device.description()))
        : Finding.note(
            SUBJECT,
            text("youMayNotOpen", device.name(), device.description()),
            text("joinTheGroupOfDevices"));
  }
}
