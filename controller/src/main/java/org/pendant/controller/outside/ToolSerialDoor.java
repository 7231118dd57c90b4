package org.pendant.controller.outside;

import java.util.List;
import org.pendant.controller.io.ToolCommunication;

/** What is at the other end of the tool's serial line (manual 18.50). No method waits. */
public interface ToolSerialDoor {
  /** Nothing is connected. */
  ToolSerialDoor NONE =
      new ToolSerialDoor() {
        @Override
        public SetUp setUp(ToolCommunication wanted) {
          return () -> true;
        }

        @Override
        public List<News> takeNews() {
          return List.of();
        }
      };

  /** A change of the line that was asked for. */
  @FunctionalInterface
  interface SetUp {
    /** Whether it has been carried out, or has failed; what failed is among the news before. */
    boolean over();
  }

  /**
   * Something to log.
   *
   * @param trouble whether it is worse than an information
   */
  record News(boolean trouble, String text) {}

  /** Sets the line up, or turns it off. What is sent after this goes out as it says. */
  SetUp setUp(ToolCommunication wanted);

  /** What has happened since the last call; one caller. */
  List<News> takeNews();
}
