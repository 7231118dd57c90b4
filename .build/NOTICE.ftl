Pendant

Pendant is under the Apache License, Version 2.0: see LICENSE. It is not affiliated with, endorsed by or
supported by Universal Robots A/S.

It comes with these libraries, each under the licence that its authors give. Where several licences
stand, the parts of the library have different ones or one of them may be chosen; the library's own
pages say which.

<#list dependencyMap as entry>
<#assign library = entry.getKey()/>
${library.name!library.artifactId} ${library.version}
    ${library.groupId}:${library.artifactId}
<#list entry.getValue() as licence>
    ${licence}
</#list>
<#if library.url??>
    ${library.url}
</#if>

</#list>
