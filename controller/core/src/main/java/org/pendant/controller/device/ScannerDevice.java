package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.device.plc.AdapterPort;
import org.pendant.controller.device.plc.AdapterScanner;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.wire.SignalOwner;
import org.pendant.models.json.Range;

/** EtherNet/IP scanner: a PLC that writes and reads the controller's built-in assemblies. */
final class ScannerDevice implements CellDevice {
  private static final double MS = 1000;

  private final DeviceSetup.EthernetIp setup;
  private final MessageLog log;
  private final AdapterScanner scanner;

  ScannerDevice(DeviceSetup.EthernetIp setup, MessageLog log) {
    this.setup = setup;
    this.log = log;
    scanner = new AdapterScanner(text("namedScanner", setup.name()), setup.intervalS(), this::tell);
    setup
        .values()
        .forEach((signal, value) -> scanner.line(signal.group(), signal.index()).set(value));
  }

  private void tell(AdapterScanner.Notice notice) {
    String name = setup.name();
    switch (notice) {
      case AdapterScanner.Notice.Connected _ -> log.info(text("scannerConnected", name));
      case AdapterScanner.Notice.Refused(String why) ->
          log.warning(text("scannerRefused", name, why));
      case AdapterScanner.Notice.TimedOut _ -> log.warning(text("scannerTimedOut", name));
    }
  }

  /** The controller's adapter is there from now on. */
  void reach(AdapterPort adapter) {
    scanner.reach(adapter);
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("ethernetIpScanner");
  }

  @Override
  public boolean on() {
    return scanner.connected();
  }

  @Override
  public String described() {
    return text("scannerAtRate", Range.number(MS * setup.intervalS()));
  }

  @Override
  public Optional<SignalOwner> signals() {
    return Optional.of(scanner::line);
  }

  @Override
  public List<SignalGroupState> signalStates() {
    return scanner.state();
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    scanner.step();
  }
}
