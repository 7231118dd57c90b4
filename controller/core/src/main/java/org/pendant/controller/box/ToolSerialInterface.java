package org.pendant.controller.box;

import java.util.List;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolSerialConnector;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;

/** Serial interface of the tool connector: the box's side of the line. The frame loop owns this. */
public final class ToolSerialInterface {
  private final ToolSerialConnector door;
  private final Signals signals;
  private final MessageLog log;

  ToolSerialInterface(ToolSerialConnector door, Signals signals, MessageLog log) {
    this.door = door;
    this.signals = signals;
    this.log = log;
  }

  /** Sets the line up, or turns it off; the analog inputs on the same wires follow at once. */
  public ToolSerialConnector.SetUp setUp(ToolCommunication wanted) {
    signals.setToolCommunication(wanted);
    return door.setUp(wanted);
  }

  /** Logs what has happened outside; every frame. */
  public void step() {
    List<ToolSerialConnector.News> news = door.takeNews();
    for (int i = 0; i < news.size(); i++) {
      ToolSerialConnector.News each = news.get(i);
      if (each.trouble()) {
        log.warning(each.text());
      } else {
        log.info(each.text());
      }
    }
  }
}
