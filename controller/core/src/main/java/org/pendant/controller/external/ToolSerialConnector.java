package org.pendant.controller.external;

import java.util.List;

/** Connector of the tool's serial line to a device (manual 18.50). No method waits. */
public interface ToolSerialConnector {
  /** Nothing is connected. */
  ToolSerialConnector NONE =
      new ToolSerialConnector() {
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
