package org.pendant.controller.device;

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
    scanner =
        new AdapterScanner("EtherNet/IP scanner " + setup.name(), setup.intervalS(), this::tell);
    setup
        .values()
        .forEach((signal, value) -> scanner.line(signal.group(), signal.index()).set(value));
  }

  private void tell(AdapterScanner.Notice notice) {
    String name = setup.name() + ": ";
    switch (notice) {
      case AdapterScanner.Notice.Connected _ ->
          log.info(name + "is connected, writes instance 112 and reads 100");
      case AdapterScanner.Notice.Refused(String why) ->
          log.warning(name + "its connection is refused (0x0106): " + why + "; it asks again");
      case AdapterScanner.Notice.TimedOut _ ->
          log.warning(name + "timed out: what it has written stays");
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
    return "EtherNet/IP scanner";
  }

  @Override
  public boolean on() {
    return scanner.connected();
  }

  @Override
  public String described() {
    return "EtherNet/IP scanner, a packet every " + Range.number(MS * setup.intervalS()) + " ms";
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
