package org.pendant.controller.disk;

import java.io.Closeable;
import java.io.IOException;

/** Open file that is being written from its beginning, without a buffer. */
interface OpenFile extends Closeable {

  /** Appends some bytes. When it fails some of them may be there. */
  void write(byte[] bytes, int from, int count) throws IOException;

  /** Removes all but the first {@code length} bytes. */
  void cut(long length) throws IOException;

  /** Has everything written to the disk. */
  void sync() throws IOException;
}
