package org.pendant.protocols.xmlrpc;

import java.io.IOException;

/** Wire: carries a call to a server and brings the answer, whatever is in them. */
interface Wire {
  /** Waits until it is known whether the server is there. */
  void probe() throws IOException;

  /** Sends a call and waits for its answer. */
  byte[] exchange(byte[] call) throws IOException;

  /** Ends the connection, any thread; another call makes a new one. */
  void close();
}
