/**
 * Where libraries unpack their native parts, so that nobody else can put code there. Open {@link
 * org.pendant.protocols.natives.NativeFolder}.
 */
package org.pendant.protocols.natives;
