/**
 * Native parts of libraries: where they are unpacked, so that no other user can put code there.
 * Open {@link org.pendant.protocols.natives.NativeFolder}.
 */
package org.pendant.protocols.natives;
