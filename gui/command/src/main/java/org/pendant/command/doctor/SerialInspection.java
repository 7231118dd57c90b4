package org.pendant.command.doctor;

import java.io.IOException;
import java.util.List;
import org.pendant.protocols.toolserial.SerialDevices;

/** Looks which serial devices there are for the tool connector, and whether they may be used. */
final class SerialInspection implements Inspection {
  private static final String SUBJECT = "Serial";

  @Override
  public List<Finding> findings() {
    try {
      List<SerialDevices.Found> devices = SerialDevices.all();
      return devices.isEmpty()
          ? List.of(Finding.ok(SUBJECT, "no devices"))
          : devices.stream().map(SerialInspection::finding).toList();
    } catch (IOException e) {
      return List.of(
          Finding.note(SUBJECT, e.getMessage(), "--tool-serial does not work; all else does"));
    }
  }

  private static Finding finding(SerialDevices.Found device) {
    String found = device.name() + ", " + device.description();
    return device.permitted()
        ? Finding.ok(SUBJECT, found)
        : Finding.note(
            SUBJECT,
            found + ", which you may not open",
            "sudo usermod -a -G dialout $USER, then log in again");
  }
}
