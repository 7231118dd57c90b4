/**
 * Disk access: files are written so that work is never lost: replaced as a whole, or growing by
 * parts that can be read whatever happens. Everything that writes files does it by this package.
 * Open {@link org.pendant.controller.disk.AtomicFile} first.
 */
package org.pendant.controller.disk;
