<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open a part…</source>
        <translation>打开零件(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a mesh (STL, OBJ, PLY, OFF) or a Moldwright project.</source>
        <translation>打开网格（STL、OBJ、PLY、OFF）或 Moldwright 项目。</translation>
    </message>
    <message>
        <source>&amp;Close the part</source>
        <translation>关闭零件(&amp;C)</translation>
    </message>
    <message>
        <source>Close the part and go back to the start page.</source>
        <translation>关闭零件，回到起始页。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the project to its file.</source>
        <translation>把项目保存到它的文件。</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the project to another file.</source>
        <translation>把项目保存到另一个文件。</translation>
    </message>
    <message>
        <source>&amp;Export the shape…</source>
        <translation>导出形状(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the shape in view as STL, PLY, OBJ or OFF.</source>
        <translation>把视图中的形状写成 STL、PLY、OBJ 或 OFF。</translation>
    </message>
    <message>
        <source>Export the &amp;halves…</source>
        <translation>导出半模(&amp;H)…</translation>
    </message>
    <message>
        <source>Write both mold halves into a folder.</source>
        <translation>把两个半模写入一个文件夹。</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Close Moldwright.</source>
        <translation>关闭 Moldwright。</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Take the last edit back.</source>
        <translation>撤回上一次编辑。</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Do the edit again.</source>
        <translation>再做一次该编辑。</translation>
    </message>
    <message>
        <source>&amp;Copy what was measured</source>
        <translation>复制测量值(&amp;C)</translation>
    </message>
    <message>
        <source>Put the measured values on the clipboard, as text.</source>
        <translation>把测量值作为文本放到剪贴板。</translation>
    </message>
    <message>
        <source>&amp;Find a command</source>
        <translation>查找命令(&amp;F)</translation>
    </message>
    <message>
        <source>Find any command by its words.</source>
        <translation>按词语查找任何命令。</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>首选项(&amp;P)…</translation>
    </message>
    <message>
        <source>Theme, language, mouse, defaults and keys.</source>
        <translation>主题、语言、鼠标、默认值和按键。</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Fit all</source>
        <translation>适合全部(&amp;F)</translation>
    </message>
    <message>
        <source>Bring everything into sight.</source>
        <translation>让全部内容进入视野。</translation>
    </message>
    <message>
        <source>&amp;Home view</source>
        <translation>初始视图(&amp;H)</translation>
    </message>
    <message>
        <source>Look from the front, right and above.</source>
        <translation>从右前上方看。</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>前(&amp;R)</translation>
    </message>
    <message>
        <source>Look from the front.</source>
        <translation>从前面看。</translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation>右(&amp;I)</translation>
    </message>
    <message>
        <source>Look from the right.</source>
        <translation>从右面看。</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>上(&amp;T)</translation>
    </message>
    <message>
        <source>Look from above.</source>
        <translation>从上面看。</translation>
    </message>
    <message>
        <source>Opp&amp;osite</source>
        <translation>对面(&amp;O)</translation>
    </message>
    <message>
        <source>Look from the other side.</source>
        <translation>从另一面看。</translation>
    </message>
    <message>
        <source>At the parting plane</source>
        <translation>正对分型面</translation>
    </message>
    <message>
        <source>Look along the normal of the parting plane.</source>
        <translation>沿分型面的法线看。</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>透视(&amp;P)</translation>
    </message>
    <message>
        <source>Show depth as the eye sees it, or without.</source>
        <translation>像眼睛那样显示深度，或不显示。</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>一个视图(&amp;O)</translation>
    </message>
    <message>
        <source>Show one view.</source>
        <translation>显示一个视图。</translation>
    </message>
    <message>
        <source>T&amp;wo views</source>
        <translation>两个视图(&amp;W)</translation>
    </message>
    <message>
        <source>Show the part and its cast beside each other.</source>
        <translation>并排显示零件和它的铸件。</translation>
    </message>
    <message>
        <source>Fo&amp;ur views</source>
        <translation>四个视图(&amp;U)</translation>
    </message>
    <message>
        <source>Show it from above, from the front, from the right, and freely.</source>
        <translation>从上、从前、从右以及自由地显示。</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>联动视图(&amp;K)</translation>
    </message>
    <message>
        <source>Let all views move together.</source>
        <translation>让所有视图一起移动。</translation>
    </message>
    <message>
        <source>&amp;Undercuts</source>
        <translation>倒扣(&amp;U)</translation>
    </message>
    <message>
        <source>Paint the faces below the required draft red.</source>
        <translation>把低于要求拔模角的面涂成红色。</translation>
    </message>
    <message>
        <source>&amp;Draft map</source>
        <translation>拔模角图(&amp;D)</translation>
    </message>
    <message>
        <source>Paint every face by its draft angle.</source>
        <translation>按拔模角给每个面上色。</translation>
    </message>
    <message>
        <source>Undercut d&amp;epth</source>
        <translation>倒扣深度(&amp;E)</translation>
    </message>
    <message>
        <source>Paint every undercut by how far it is blocked, in mm.</source>
        <translation>按受阻的距离（毫米）给每个倒扣上色。</translation>
    </message>
    <message>
        <source>De&amp;viation</source>
        <translation>偏差(&amp;V)</translation>
    </message>
    <message>
        <source>Paint how far cast and part are apart, in mm.</source>
        <translation>按铸件与零件的距离（毫米）上色。</translation>
    </message>
    <message>
        <source>&amp;Strain</source>
        <translation>应变(&amp;S)</translation>
    </message>
    <message>
        <source>Paint how much the surface was stretched, in percent.</source>
        <translation>按表面拉伸的百分比上色。</translation>
    </message>
    <message>
        <source>P&amp;lain</source>
        <translation>素色(&amp;L)</translation>
    </message>
    <message>
        <source>Show the shape alone.</source>
        <translation>只显示形状。</translation>
    </message>
    <message>
        <source>Parting plane</source>
        <translation>分型面</translation>
    </message>
    <message>
        <source>Show or hide the parting plane.</source>
        <translation>显示或隐藏分型面。</translation>
    </message>
    <message>
        <source>Removal directions</source>
        <translation>脱模方向</translation>
    </message>
    <message>
        <source>Show or hide both removal directions.</source>
        <translation>显示或隐藏两个脱模方向。</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>网格边</translation>
    </message>
    <message>
        <source>Show or hide the edges of the faces.</source>
        <translation>显示或隐藏面的边。</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>Show the shape as if it were glass.</source>
        <translation>像玻璃一样显示形状。</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>Click places on the surface: draft, thickness, distance, angle. Esc leaves.</source>
        <translation>点击表面上的位置：拔模角、厚度、距离、角度。Esc 退出。</translation>
    </message>
    <message>
        <source>Se&amp;ction</source>
        <translation>剖切(&amp;C)</translation>
    </message>
    <message>
        <source>Cut the view open at the parting plane, or anywhere along it.</source>
        <translation>在分型面处或沿它的任何位置剖开视图。</translation>
    </message>
    <message>
        <source>Save a picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Write the view as a PNG picture.</source>
        <translation>把视图写成 PNG 图片。</translation>
    </message>
    <message>
        <source>Save a t&amp;urntable…</source>
        <translation>保存旋转动画(&amp;U)…</translation>
    </message>
    <message>
        <source>Turn the view once around and write an animated PNG. Esc stops.</source>
        <translation>让视图转一圈并写成动态 PNG。Esc 停止。</translation>
    </message>
    <message>
        <source>&amp;Part</source>
        <translation>零件(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Lay flat on a face</source>
        <translation>以一个面放平(&amp;L)</translation>
    </message>
    <message>
        <source>Click the face that shall lie on the ground. Esc leaves.</source>
        <translation>点击要放在地面上的面。Esc 退出。</translation>
    </message>
    <message>
        <source>Turn about &amp;X</source>
        <translation>绕 &amp;X 转</translation>
    </message>
    <message>
        <source>Turn the part by 90° about the x axis.</source>
        <translation>把零件绕 X 轴转 90°。</translation>
    </message>
    <message>
        <source>Turn about &amp;Y</source>
        <translation>绕 &amp;Y 转</translation>
    </message>
    <message>
        <source>Turn the part by 90° about the y axis.</source>
        <translation>把零件绕 Y 轴转 90°。</translation>
    </message>
    <message>
        <source>Turn about &amp;Z</source>
        <translation>绕 &amp;Z 转</translation>
    </message>
    <message>
        <source>Turn the part by 90° about the z axis.</source>
        <translation>把零件绕 Z 轴转 90°。</translation>
    </message>
    <message>
        <source>Tu&amp;rn by an angle…</source>
        <translation>转任意角度(&amp;R)…</translation>
    </message>
    <message>
        <source>Turn the part about an axis, by any angle.</source>
        <translation>把零件绕一根轴转任意角度。</translation>
    </message>
    <message>
        <source>Move to the &amp;middle</source>
        <translation>移到中间(&amp;M)</translation>
    </message>
    <message>
        <source>Put the middle of the part above the origin, on the ground.</source>
        <translation>把零件的中心放在原点上方的地面上。</translation>
    </message>
    <message>
        <source>P&amp;lane</source>
        <translation>平面(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Best plane</source>
        <translation>最佳平面(&amp;B)</translation>
    </message>
    <message>
        <source>Search all planes for the one that leaves the least to deform.</source>
        <translation>搜索所有平面，找出需要变形最少的一个。</translation>
    </message>
    <message>
        <source>&amp;Next best plane</source>
        <translation>下一个最佳平面(&amp;N)</translation>
    </message>
    <message>
        <source>Take the next plane of the last search.</source>
        <translation>采用上次搜索的下一个平面。</translation>
    </message>
    <message>
        <source>Take the &amp;suggested plane</source>
        <translation>采用建议的平面(&amp;S)</translation>
    </message>
    <message>
        <source>Part the part where nothing stands in the way of the mold.</source>
        <translation>在没有东西挡住模具的地方分型。</translation>
    </message>
    <message>
        <source>Best &amp;directions</source>
        <translation>最佳方向(&amp;D)</translation>
    </message>
    <message>
        <source>Tilt both directions to where the least is left to deform.</source>
        <translation>把两个方向倾斜到需要变形最少处。</translation>
    </message>
    <message>
        <source>Directions along the &amp;normal</source>
        <translation>方向沿法线(&amp;N)</translation>
    </message>
    <message>
        <source>Let both halves leave straight along the plane&apos;s normal.</source>
        <translation>让两个半模沿平面法线直线离开。</translation>
    </message>
    <message>
        <source>Square to &amp;X</source>
        <translation>垂直于 &amp;X</translation>
    </message>
    <message>
        <source>Turn the plane square to the x axis; it stays where it is in the part.</source>
        <translation>让平面垂直于 X 轴；它在零件中的位置不变。</translation>
    </message>
    <message>
        <source>Square to &amp;Y</source>
        <translation>垂直于 &amp;Y</translation>
    </message>
    <message>
        <source>Turn the plane square to the y axis; it stays where it is in the part.</source>
        <translation>让平面垂直于 Y 轴；它在零件中的位置不变。</translation>
    </message>
    <message>
        <source>Square to &amp;Z</source>
        <translation>垂直于 &amp;Z</translation>
    </message>
    <message>
        <source>Turn the plane square to the z axis; it stays where it is in the part.</source>
        <translation>让平面垂直于 Z 轴；它在零件中的位置不变。</translation>
    </message>
    <message>
        <source>Through three &amp;points</source>
        <translation>过三个点(&amp;P)</translation>
    </message>
    <message>
        <source>Click three places that the plane shall run through. Esc leaves.</source>
        <translation>点击平面要通过的三个位置。Esc 退出。</translation>
    </message>
    <message>
        <source>On a &amp;face</source>
        <translation>放到面上(&amp;F)</translation>
    </message>
    <message>
        <source>Click the face that the plane shall lie in. Esc leaves.</source>
        <translation>点击平面要所在的面。Esc 退出。</translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation>引导(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Pin a point</source>
        <translation>固定一个点(&amp;P)</translation>
    </message>
    <message>
        <source>Click points of the part that shall lie on the parting plane. Esc leaves.</source>
        <translation>点击零件上应位于分型面上的点。Esc 退出。</translation>
    </message>
    <message>
        <source>Pin a point &amp;inside</source>
        <translation>固定内部的点(&amp;I)</translation>
    </message>
    <message>
        <source>Click to pin the point farthest inside below the pointer. Esc leaves.</source>
        <translation>点击以固定指针下方最深的内部点。Esc 退出。</translation>
    </message>
    <message>
        <source>&amp;Suggest pins</source>
        <translation>建议固定点(&amp;S)</translation>
    </message>
    <message>
        <source>Look for points worth pinning: ends of limbs, where limbs meet, along the body.</source>
        <translation>寻找值得固定的点：肢端、肢体交汇处、沿躯干。</translation>
    </message>
    <message>
        <source>Accept &amp;tips</source>
        <translation>接受肢端(&amp;T)</translation>
    </message>
    <message>
        <source>Pin all suggested points that are ends of limbs.</source>
        <translation>固定所有属于肢端的建议点。</translation>
    </message>
    <message>
        <source>Remove &amp;all pins</source>
        <translation>移除所有固定点(&amp;A)</translation>
    </message>
    <message>
        <source>Remove all pins; the suggested ones stay.</source>
        <translation>移除所有固定点；建议的点保留。</translation>
    </message>
    <message>
        <source>Pins from a &amp;file…</source>
        <translation>从文件读固定点(&amp;F)…</translation>
    </message>
    <message>
        <source>Read pins from a JSON file, as the command line takes it.</source>
        <translation>从 JSON 文件读取固定点，格式与命令行相同。</translation>
    </message>
    <message>
        <source>Pins &amp;into a file…</source>
        <translation>固定点写入文件(&amp;I)…</translation>
    </message>
    <message>
        <source>Write all pins as JSON for the command line or another project.</source>
        <translation>把所有固定点写成 JSON，供命令行或其他项目使用。</translation>
    </message>
    <message>
        <source>&amp;Deform</source>
        <translation>变形(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>Bend the part until it leaves the mold, and prove it.</source>
        <translation>弯曲零件直到它能脱模，并加以证明。</translation>
    </message>
    <message>
        <source>Fi&amp;ll and run</source>
        <translation>填充并运行(&amp;L)</translation>
    </message>
    <message>
        <source>Run, and fill the places that no bending frees.</source>
        <translation>运行，并填充弯曲无法解开的地方。</translation>
    </message>
    <message>
        <source>Find &amp;undercuts</source>
        <translation>查找倒扣(&amp;U)</translation>
    </message>
    <message>
        <source>List the undercuts at this plane, to have each one bent or filled.</source>
        <translation>列出此平面的倒扣，逐个决定弯曲或填充。</translation>
    </message>
    <message>
        <source>Fill or &amp;join here</source>
        <translation>在此填充或连接(&amp;J)</translation>
    </message>
    <message>
        <source>Have what the chosen obstruction spans filled; Run bends the rest.</source>
        <translation>填充所选障碍跨越之处；运行会弯曲其余部分。</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>完成(&amp;F)</translation>
    </message>
    <message>
        <source>Bend no further: finish the shape from where it is, and prove it.</source>
        <translation>不再弯曲：从现状完成形状，并加以证明。</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Hold the shape where it is, or bend it further.</source>
        <translation>让形状停住，或继续弯曲。</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>End the run; the shape it reached is kept.</source>
        <translation>结束运行；保留已达到的形状。</translation>
    </message>
    <message>
        <source>Restore original shape</source>
        <translation>恢复原始形状</translation>
    </message>
    <message>
        <source>Back to the undeformed part; the plane stays.</source>
        <translation>回到未变形的零件；平面保留。</translation>
    </message>
    <message>
        <source>&amp;Mold</source>
        <translation>模具(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Build mold</source>
        <translation>构建模具(&amp;B)</translation>
    </message>
    <message>
        <source>Make both mold halves around the cast, and prove that they come off.</source>
        <translation>围绕铸件制作两个半模，并证明它们能脱开。</translation>
    </message>
    <message>
        <source>&amp;Open or close the mold</source>
        <translation>打开或合上模具(&amp;O)</translation>
    </message>
    <message>
        <source>Move the halves apart along their directions, or together.</source>
        <translation>让半模沿其方向分开或合拢。</translation>
    </message>
    <message>
        <source>&amp;Report</source>
        <translation>报告(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Print report…</source>
        <translation>打印报告(&amp;P)…</translation>
    </message>
    <message>
        <source>Make a PDF with pictures, draft, volumes and the proof.</source>
        <translation>生成包含图片、拔模角、体积和证明的 PDF。</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Use the light theme.</source>
        <translation>使用浅色主题。</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Use the dark theme.</source>
        <translation>使用深色主题。</translation>
    </message>
    <message>
        <source>Like the desk&amp;top</source>
        <translation>跟随桌面(&amp;T)</translation>
    </message>
    <message>
        <source>Follow the desktop&apos;s colours.</source>
        <translation>跟随桌面的颜色。</translation>
    </message>
    <message>
        <source>Go to Part</source>
        <translation>到“零件”</translation>
    </message>
    <message>
        <source>Go to the step Part.</source>
        <translation>转到“零件”步骤。</translation>
    </message>
    <message>
        <source>Go to Plane</source>
        <translation>到“平面”</translation>
    </message>
    <message>
        <source>Go to the step Plane.</source>
        <translation>转到“平面”步骤。</translation>
    </message>
    <message>
        <source>Go to Guides</source>
        <translation>到“引导”</translation>
    </message>
    <message>
        <source>Go to the step Guides.</source>
        <translation>转到“引导”步骤。</translation>
    </message>
    <message>
        <source>Go to Deform</source>
        <translation>到“变形”</translation>
    </message>
    <message>
        <source>Go to the step Deform.</source>
        <translation>转到“变形”步骤。</translation>
    </message>
    <message>
        <source>Go to Check</source>
        <translation>到“检查”</translation>
    </message>
    <message>
        <source>Go to the step Check.</source>
        <translation>转到“检查”步骤。</translation>
    </message>
    <message>
        <source>Go to Mold</source>
        <translation>到“模具”</translation>
    </message>
    <message>
        <source>Go to the step Mold.</source>
        <translation>转到“模具”步骤。</translation>
    </message>
    <message>
        <source>Go to Report</source>
        <translation>到“报告”</translation>
    </message>
    <message>
        <source>Go to the step Report.</source>
        <translation>转到“报告”步骤。</translation>
    </message>
    <message>
        <source>Next area</source>
        <translation>下一个区域</translation>
    </message>
    <message>
        <source>Move the keyboard to the next area of the window.</source>
        <translation>把键盘移到窗口的下一个区域。</translation>
    </message>
    <message>
        <source>Previous area</source>
        <translation>上一个区域</translation>
    </message>
    <message>
        <source>Move the keyboard to the previous area of the window.</source>
        <translation>把键盘移到窗口的上一个区域。</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>Put all panels back where they were at first.</source>
        <translation>把所有面板放回最初的位置。</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>按键与鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>Show all keys on one sheet.</source>
        <translation>在一页上显示所有按键。</translation>
    </message>
    <message>
        <source>Take the &amp;tour</source>
        <translation>导览(&amp;T)</translation>
    </message>
    <message>
        <source>Five steps from a part to its mold, at your own pace.</source>
        <translation>从零件到模具的五个步骤，快慢由您。</translation>
    </message>
    <message>
        <source>&amp;About Moldwright</source>
        <translation>关于 Moldwright(&amp;A)</translation>
    </message>
    <message>
        <source>Version, licence, libraries.</source>
        <translation>版本、许可证、程序库。</translation>
    </message>
    <message>
        <source>&amp;Importance</source>
        <translation>重要性(&amp;I)</translation>
    </message>
    <message>
        <source>Paint every face by how important it is to keep its shape.</source>
        <translation>按保持形状的重要程度为每个面着色。</translation>
    </message>
    <message>
        <source>&amp;Remove what is chosen</source>
        <translation>移除所选(&amp;R)</translation>
    </message>
    <message>
        <source>P&amp;aint importance</source>
        <translation>绘制重要性(&amp;A)</translation>
    </message>
    <message>
        <source>Draw over what is to keep its shape: each stroke doubles its weight. Esc leaves.</source>
        <translation>在要保持形状的地方涂画：每一笔使权重加倍。按 Esc 退出。</translation>
    </message>
    <message>
        <source>Paint up to &amp;creases</source>
        <translation>绘制到折痕为止(&amp;C)</translation>
    </message>
    <message>
        <source>Click a face: the stroke goes as far as the surface is smooth. Esc leaves.</source>
        <translation>点击一个面：这一笔延伸到表面不再光滑处。按 Esc 退出。</translation>
    </message>
    <message>
        <source>Paint a whole p&amp;iece</source>
        <translation>绘制整个连通块(&amp;I)</translation>
    </message>
    <message>
        <source>Click a face: the stroke takes all that is connected with it. Esc leaves.</source>
        <translation>点击一个面：这一笔涵盖与之相连的全部。按 Esc 退出。</translation>
    </message>
    <message>
        <source>Paint in a &amp;lasso</source>
        <translation>在套索内绘制(&amp;L)</translation>
    </message>
    <message>
        <source>Draw around what is to be painted: faces that are seen inside. Esc leaves.</source>
        <translation>圈出要绘制的部分：其中可见的面。按 Esc 退出。</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>擦除(&amp;E)</translation>
    </message>
    <message>
        <source>Let strokes halve weights instead of doubling them; Ctrl does the opposite.</source>
        <translation>让笔画把权重减半而不是加倍；按住 Ctrl 则相反。</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>缩小画笔(&amp;M)</translation>
    </message>
    <message>
        <source>Make the brush smaller. Alt and the wheel do so too.</source>
        <translation>缩小画笔。Alt 加滚轮也可以。</translation>
    </message>
    <message>
        <source>Lar&amp;ger brush</source>
        <translation>放大画笔(&amp;G)</translation>
    </message>
    <message>
        <source>Make the brush larger. Alt and the wheel do so too.</source>
        <translation>放大画笔。Alt 加滚轮也可以。</translation>
    </message>
    <message>
        <source>&amp;New region</source>
        <translation>新区域(&amp;N)</translation>
    </message>
    <message>
        <source>Let the next stroke make a region of its own.</source>
        <translation>让下一笔成为单独的区域。</translation>
    </message>
    <message>
        <source>Remove all re&amp;gions</source>
        <translation>移除所有区域(&amp;G)</translation>
    </message>
    <message>
        <source>Nothing is more important than the rest then.</source>
        <translation>此后没有任何部分比其余部分更重要。</translation>
    </message>
    <message>
        <source>Regions from a file…</source>
        <translation>从文件读区域…</translation>
    </message>
    <message>
        <source>Read important regions from a JSON file, as the command line takes it.</source>
        <translation>从 JSON 文件读取重要区域，格式与命令行相同。</translation>
    </message>
    <message>
        <source>Regions into a file…</source>
        <translation>区域写入文件…</translation>
    </message>
    <message>
        <source>Write all regions as JSON for the command line or another project.</source>
        <translation>把所有区域写成 JSON，供命令行或其他项目使用。</translation>
    </message>
    <message>
        <source>One s&amp;tep</source>
        <translation>单步(&amp;T)</translation>
    </message>
    <message>
        <source>Bend a paused shape by one step.</source>
        <translation>将暂停的形状再变形一步。</translation>
    </message>
    <message>
        <source>&amp;Earlier frame</source>
        <translation>前一帧(&amp;E)</translation>
    </message>
    <message>
        <source>Look at the frame before; a run pauses.</source>
        <translation>查看前一帧；运行会暂停。</translation>
    </message>
    <message>
        <source>&amp;Later frame</source>
        <translation>后一帧(&amp;L)</translation>
    </message>
    <message>
        <source>Look at the frame after.</source>
        <translation>查看后一帧。</translation>
    </message>
    <message>
        <source>Go on from &amp;here</source>
        <translation>从此处继续(&amp;H)</translation>
    </message>
    <message>
        <source>Run anew from the shape, plane and settings of the frame in view.</source>
        <translation>从所示帧的形状、分型面和设置重新运行。</translation>
    </message>
    <message>
        <source>&amp;New variant</source>
        <translation>新建变型(&amp;N)</translation>
    </message>
    <message>
        <source>Begin another design of this part, without pins and regions.</source>
        <translation>为此零件开始另一个设计，不带固定点和区域。</translation>
    </message>
    <message>
        <source>&amp;Duplicate the variant</source>
        <translation>复制变型(&amp;D)</translation>
    </message>
    <message>
        <source>Work on a copy of this design; the other stays as it is.</source>
        <translation>在此设计的副本上工作；原来的保持不变。</translation>
    </message>
    <message>
        <source>Make &amp;current</source>
        <translation>设为当前(&amp;C)</translation>
    </message>
    <message>
        <source>Go on with the variant that is chosen.</source>
        <translation>继续处理选中的变型。</translation>
    </message>
    <message>
        <source>Next &amp;variant</source>
        <translation>下一个变型(&amp;V)</translation>
    </message>
    <message>
        <source>Go on with the next variant of this part.</source>
        <translation>继续处理此零件的下一个变型。</translation>
    </message>
    <message>
        <source>Previous v&amp;ariant</source>
        <translation>上一个变型(&amp;A)</translation>
    </message>
    <message>
        <source>Go on with the variant before this one.</source>
        <translation>继续处理前一个变型。</translation>
    </message>
    <message>
        <source>C&amp;ompare</source>
        <translation>比较(&amp;O)</translation>
    </message>
    <message>
        <source>Show another variant beside the current one, and how far their casts are apart.</source>
        <translation>在当前变型旁显示另一个变型，以及两个铸件相距多远。</translation>
    </message>
    <message>
        <source>R&amp;ename</source>
        <translation>重命名(&amp;E)</translation>
    </message>
    <message>
        <source>Differe&amp;nce</source>
        <translation>差异(&amp;N)</translation>
    </message>
    <message>
        <source>Paint how far the casts of two compared variants are apart, in mm.</source>
        <translation>按两个被比较变型的铸件相距多远着色，单位 mm。</translation>
    </message>
    <message>
        <source>Place &amp;automatically</source>
        <translation>自动放置(&amp;A)</translation>
    </message>
    <message>
        <source>Give the chosen feature of the mold back to the program.</source>
        <translation>将所选的模具特征交还给程序放置。</translation>
    </message>
    <message>
        <source>Place a&amp;ll automatically</source>
        <translation>全部自动放置(&amp;L)</translation>
    </message>
    <message>
        <source>Give all features of the mold back that a hand has placed.</source>
        <translation>将所有手动放置的模具特征交还给程序。</translation>
    </message>
    <message>
        <source>Accept in a lass&amp;o</source>
        <translation>接受套索内的点(&amp;O)</translation>
    </message>
    <message>
        <source>Draw around suggested points: all inside are pinned. Esc leaves.</source>
        <translation>圈出建议点：圈内的点全部被固定。Esc 退出。</translation>
    </message>
    <message>
        <source>&amp;Save as a preset…</source>
        <translation>保存为预设(&amp;S)…</translation>
    </message>
    <message>
        <source>Keep block, layout, features and machines under a name, for other parts.</source>
        <translation>以某名称保存模块、布局、结构和设备，供其他零件使用。</translation>
    </message>
    <message>
        <source>&amp;Remove the preset</source>
        <translation>移除预设(&amp;R)</translation>
    </message>
    <message>
        <source>Forget it; the mold keeps its settings.</source>
        <translation>删除该预设；模具设置保持不变。</translation>
    </message>
    <message>
        <source>Re&amp;cover lost work</source>
        <translation>恢复丢失的工作(&amp;C)</translation>
    </message>
    <message>
        <source>Open what was not saved last time.</source>
        <translation>打开上次未保存的内容。</translation>
    </message>
    <message>
        <source>Give what is chosen another name.</source>
        <translation>为所选项另取名称。</translation>
    </message>
    <message>
        <source>&amp;Show or hide</source>
        <translation>显示或隐藏(&amp;S)</translation>
    </message>
    <message>
        <source>Show or hide what is chosen.</source>
        <translation>显示或隐藏所选项。</translation>
    </message>
    <message>
        <source>Fit what is &amp;chosen</source>
        <translation>适合所选(&amp;C)</translation>
    </message>
    <message>
        <source>Bring what is chosen in the project into sight; else everything.</source>
        <translation>使项目中所选内容可见；未选时显示全部。</translation>
    </message>
    <message>
        <source>S&amp;teel</source>
        <translation>钢料厚度(&amp;T)</translation>
    </message>
    <message>
        <source>Paint the walls of the mold by the steel behind them, in mm.</source>
        <translation>按壁后钢料厚度（毫米）给模具型壁着色。</translation>
    </message>
    <message>
        <source>Read the file &amp;again</source>
        <translation>重新读取文件(&amp;A)</translation>
    </message>
    <message>
        <source>Read the mesh that cannot be used once more, after it was mended in the program that made it.</source>
        <translation>在原程序中修复后，重新读取无法使用的网格。</translation>
    </message>
    <message>
        <source>&amp;Back to what was open</source>
        <translation>返回之前打开的内容(&amp;B)</translation>
    </message>
    <message>
        <source>Leave the mesh that cannot be used; what was open before comes back. Esc does so too.</source>
        <translation>离开无法使用的网格，恢复之前打开的内容。按 Esc 也可以。</translation>
    </message>
    <message>
        <source>Copy the &amp;diagnosis</source>
        <translation>复制诊断(&amp;D)</translation>
    </message>
    <message>
        <source>Put all that is wrong with the mesh on the clipboard, as text.</source>
        <translation>将网格的所有问题以文本形式放入剪贴板。</translation>
    </message>
    <message>
        <source>Show the ne&amp;xt place</source>
        <translation>显示下一处(&amp;X)</translation>
    </message>
    <message>
        <source>Bring the next place where the mesh cannot be used into sight.</source>
        <translation>将网格无法使用的下一处移入视图。</translation>
    </message>
    <message>
        <source>Re&amp;pair the mesh</source>
        <translation>修复网格(&amp;P)</translation>
    </message>
    <message>
        <source>Mend what is wrong with the mesh, or make a closed skin about it, and open that. The file stays as it is.</source>
        <translation>修补网格的问题，或在其外做一层封闭外壳，然后打开。文件保持不变。</translation>
    </message>
    <message>
        <source>&amp;Materials…</source>
        <translation>材料(&amp;M)…</translation>
    </message>
    <message>
        <source>Look at what materials ask for, change them, add your own.</source>
        <translation>查看各材料的要求,修改它们,添加自己的材料。</translation>
    </message>
    <message>
        <source>&amp;Design with its draft</source>
        <translation>按其斜度设计(&amp;D)</translation>
    </message>
    <message>
        <source>Ask for the draft that is usual for the chosen material; the cast is to be designed anew.</source>
        <translation>要求所选材料的常用斜度;铸件需重新设计。</translation>
    </message>
    <message>
        <source>Remove the pin, the region, the variant or the part of the mold that is chosen.</source>
        <translation>移除选中的固定点、区域、变型或模具中的零件。</translation>
    </message>
    <message>
        <source>Add a &amp;part to the mold…</source>
        <translation>向模具添加零件(&amp;P)…</translation>
    </message>
    <message>
        <source>Give the mold cavities of other finished casts, from their project files.</source>
        <translation>让模具也具有其他已完成铸件的型腔，取自其项目文件。</translation>
    </message>
    <message>
        <source>Read the part a&amp;gain</source>
        <translation>重新读取零件(&amp;G)</translation>
    </message>
    <message>
        <source>Take the chosen part of the mold from its project file as it is now.</source>
        <translation>按项目文件的当前内容重新读取模具中选定的零件。</translation>
    </message>
</context>
<context>
    <name>DisplayMode</name>
    <message>
        <source>Undercuts</source>
        <translation>倒扣</translation>
    </message>
    <message>
        <source>Draft map</source>
        <translation>拔模角图</translation>
    </message>
    <message>
        <source>Undercut depth</source>
        <translation>倒扣深度</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>素色</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>重要性</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>钢料厚度</translation>
    </message>
</context>
<context>
    <name>FacePaint</name>
    <message>
        <source>Undercuts</source>
        <translation>倒扣</translation>
    </message>
    <message>
        <source>Draft below %1</source>
        <translation>拔模角低于 %1</translation>
    </message>
    <message>
        <source>Draft %1 or more</source>
        <translation>拔模角 %1 或以上</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>拔模角</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>低于 %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>高于 %1</translation>
    </message>
    <message>
        <source>mm, after best fit</source>
        <translation>毫米，最佳拟合后</translation>
    </message>
    <message>
        <source>%, both stretches together</source>
        <translation>%，两个方向的拉伸合计</translation>
    </message>
    <message>
        <source>mm along the removal direction</source>
        <translation>毫米，沿脱模方向</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 或以上</translation>
    </message>
    <message>
        <source>No undercut</source>
        <translation>无倒扣</translation>
    </message>
    <message>
        <source>Shown once the run has ended.</source>
        <translation>运行结束后显示。</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Needs a parting plane.</source>
        <translation>需要分型面。</translation>
    </message>
    <message>
        <source>Needs a cast: Run makes one.</source>
        <translation>需要铸件：运行即可得到。</translation>
    </message>
    <message>
        <source>The file is of an older version: run again.</source>
        <translation>文件来自旧版本：请重新运行。</translation>
    </message>
    <message>
        <source>Shown on the cast only.</source>
        <translation>只在铸件上显示。</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>mm between both casts</source>
        <translation>mm，两个铸件之间</translation>
    </message>
    <message>
        <source>Needs another variant: Compare shows one.</source>
        <translation>需要另一个变型：“比较”可显示。</translation>
    </message>
    <message>
        <source>Needs a cast in both variants.</source>
        <translation>两个变型都需要有铸件。</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>A half meets the cast</source>
        <translation>半模碰到铸件</translation>
    </message>
</context>
<context>
    <name>Guides</name>
    <message>
        <source>{0} could not be read.</source>
        <translation>无法读取 {0}。</translation>
    </message>
    <message>
        <source>{0} is not JSON: it goes wrong at byte {1}.</source>
        <translation>{0} 不是 JSON：在第 {1} 字节处出错。</translation>
    </message>
    <message>
        <source>{0} has no list &quot;{1}&quot;.</source>
        <translation>{0} 没有列表“{1}”。</translation>
    </message>
    <message>
        <source>{0}: the &quot;faces&quot; of region {1} have to be numbers from 0 to {2}.</source>
        <translation>{0}：区域 {1} 的 &quot;faces&quot; 必须是 0 到 {2} 的数字。</translation>
    </message>
    <message>
        <source>{0}: region {1} needs a &quot;centre&quot; of three numbers and a positive &quot;radius&quot;, or a list of &quot;faces&quot;.</source>
        <translation>{0}：区域 {1} 需要由三个数字组成的 &quot;centre&quot; 和正的 &quot;radius&quot;，或一个 &quot;faces&quot; 列表。</translation>
    </message>
    <message>
        <source>{0}: region {1} has no face of the part in it.</source>
        <translation>{0}：区域 {1} 中没有零件的面。</translation>
    </message>
    <message>
        <source>{0}: the &quot;keep_within&quot; of region {1} has to be a positive number of millimetres.</source>
        <translation>{0}：区域 {1} 的 &quot;keep_within&quot; 必须是正的毫米数。</translation>
    </message>
    <message>
        <source>{0}: pin {1} needs a &quot;point&quot; of three numbers.</source>
        <translation>{0}：固定点 {1} 需要由三个数字组成的 &quot;point&quot;。</translation>
    </message>
    <message>
        <source>{0}: pin {1} lies {2} mm outside the part. Pins are in the part&apos;s millimetres, after --units, --scale or --size.</source>
        <translation>{0}：固定点 {1} 在零件外 {2} mm 处。固定点以零件的毫米计，在 --units、--scale 或 --size 之后。</translation>
    </message>
    <message>
        <source>{0}: region {1} needs a &quot;weight&quot; from 1 (like the rest) to 65536, or with &quot;faces&quot; a list of such, one for each.</source>
        <translation>{0}：区域 {1} 需要一个 1（与其余相同）到 65536 的 &quot;weight&quot;，或者配合 &quot;faces&quot; 给出一个列表，每个面一个。</translation>
    </message>
    <message>
        <source>{0}: entry {1} puts a feature to another place than an entry before it.</source>
        <translation>{0}：条目 {1} 将一个特征放到与之前条目不同的位置。</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is no place of a cavity: write x, y and, if it is turned, an angle in degrees; a semicolon between places.</source>
        <translation>“{0}”不是型腔位置：请写 x、y，如有旋转再写角度（度）；位置之间用分号。</translation>
    </message>
    <message>
        <source>The place of cavity {0} needs &quot;at&quot; with two numbers, mm.</source>
        <translation>型腔 {0} 的位置需要 &quot;at&quot;，含两个数字，单位 mm。</translation>
    </message>
    <message>
        <source>{0}: entry {1} needs a &quot;kind&quot; (spout, vent, key, slit, bolt, ejector, overflow or pocket), a &quot;number&quot; from 1, and &quot;at&quot; with two numbers, mm.</source>
        <translation>{0}：条目 {1} 需要 “kind”（spout、vent、key、slit、bolt、ejector、overflow 或 pocket）、从 1 起的 “number”，以及含两个数（mm）的 “at”。</translation>
    </message>
</context>
<context>
    <name>ImportancePages</name>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Measured over the surface, so the brush does not jump to a near wall.</source>
        <translation>沿表面测量，因此画笔不会跳到邻近的壁上。</translation>
    </message>
    <message>
        <source>Stop at creases</source>
        <translation>止于折痕</translation>
    </message>
    <message>
        <source>How sharp an edge must be for the face tool to end there.</source>
        <translation>边要有多尖锐，面工具才止于此。</translation>
    </message>
    <message>
        <source>Each stroke doubles the weight of what it covers; with Ctrl it halves it.</source>
        <translation>每一笔使所覆盖部分的权重加倍；按住 Ctrl 则减半。</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>重要性</translation>
    </message>
    <message>
        <source>What is painted keeps its shape; the rest gives way.</source>
        <translation>绘制的部分保持形状；其余部分让步。</translation>
    </message>
    <message>
        <source>All regions</source>
        <translation>所有区域</translation>
    </message>
    <message>
        <source>No region yet. A stroke makes one; F2 gives it a name.</source>
        <translation>尚无区域。画一笔即成一个；按 F2 命名。</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Within their limits</source>
        <translation>在限度之内</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 中的 %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>The heaviest of its faces. Typed, it is given to all of them; 1 is only measured.</source>
        <translation>其中最重的面的权重。输入后赋予所有面；1 表示只测量。</translation>
    </message>
    <message>
        <source>Keep within ±</source>
        <translation>保持在 ± 之内</translation>
    </message>
    <message>
        <source>How far its points may move against each other; 0 is no limit.</source>
        <translation>其各点之间可以相对移动多远；0 表示不限。</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面数</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Measured in the cast</source>
        <translation>在铸件中测得</translation>
    </message>
    <message>
        <source>Largest change</source>
        <translation>最大变化</translation>
    </message>
    <message>
        <source>Of its shape, wherever it went as a whole: after its own best fit.</source>
        <translation>指其形状的变化，不论整体移到何处：经自身最佳拟合之后。</translation>
    </message>
    <message>
        <source>Mean change</source>
        <translation>平均变化</translation>
    </message>
    <message>
        <source>Root of the mean square.</source>
        <translation>均方根。</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>How much its surface was stretched.</source>
        <translation>其表面被拉伸了多少。</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>%1 regions</source>
        <translation>%1 个区域</translation>
    </message>
</context>
<context>
    <name>ImportancePaint</name>
    <message>
        <source>Importance</source>
        <translation>重要性</translation>
    </message>
    <message>
        <source>like the rest</source>
        <translation>与其余相同</translation>
    </message>
    <message>
        <source>×32 or more</source>
        <translation>×32 或以上</translation>
    </message>
    <message>
        <source>Looking where the faces come from</source>
        <translation>正在查找各面的来源</translation>
    </message>
    <message>
        <source>Not known for this shape.</source>
        <translation>此形状无此信息。</translation>
    </message>
</context>
<context>
    <name>Materials</name>
    <message>
        <source>{0} is not a table of materials: {1}.</source>
        <translation>{0} 不是材料表：{1}。</translation>
    </message>
    <message>
        <source>There is no material {0}. Known are: {1}.</source>
        <translation>没有材料 {0}。已知的有：{1}。</translation>
    </message>
    <message>
        <source>{0}: the material {1} cannot be right. {2}</source>
        <translation>{0}:材料 {1} 不可能正确。{2}</translation>
    </message>
    <message>
        <source>A material needs a name.</source>
        <translation>材料需要名称。</translation>
    </message>
    <message>
        <source>Shrink must be between −50 and 50 %.</source>
        <translation>收缩率必须在 −50 % 与 50 % 之间。</translation>
    </message>
    <message>
        <source>Draft must be from 0 to less than 45°.</source>
        <translation>斜度必须从 0 到小于 45°。</translation>
    </message>
    <message>
        <source>Density must be between 0 and 30 g/cm³.</source>
        <translation>密度必须在 0 与 30 g/cm³ 之间。</translation>
    </message>
    <message>
        <source>Vents must be more than 0 and at most 5 mm deep.</source>
        <translation>排气槽深度必须大于 0 且不超过 5 mm。</translation>
    </message>
    <message>
        <source>{0} cannot be read.</source>
        <translation>无法读取 {0}。</translation>
    </message>
    <message>
        <source>{0} could not be removed: {1}.</source>
        <translation>无法删除 {0}:{1}。</translation>
    </message>
    <message>
        <source>A material cannot be kept as “{0}”: up to 60 lower-case letters, digits and hyphens can name one.</source>
        <translation>材料不能以“{0}”保存:名称最多 60 个小写字母、数字和连字符。</translation>
    </message>
    <message>
        <source>None of your own materials is {0}.</source>
        <translation>您自己的材料中没有 {0}。</translation>
    </message>
    <message>
        <source>Sealing the mold: {0}</source>
        <translation>封闭模具:{0}</translation>
    </message>
    <message>
        <source>Release agent: {0}</source>
        <translation>脱模剂:{0}</translation>
    </message>
    <message>
        <source>Filling: {0}</source>
        <translation>填充:{0}</translation>
    </message>
    <message>
        <source>Setting: {0}</source>
        <translation>固化:{0}</translation>
    </message>
    <message>
        <source>Preparation by {0}.</source>
        <translation>准备方法依据 {0}。</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>收缩率</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Depth of vents in the parting plane</source>
        <translation>分型面内排气槽深度</translation>
    </message>
    <message>
        <source>{0}: {1} is set otherwise here; usual is {2} ({3}).</source>
        <translation>{0}:{1}在此另有设定;常用为 {2}({3})。</translation>
    </message>
    <message>
        <source>{0}: {1} {2} ({3}).</source>
        <translation>{0}:{1} {2}({3})。</translation>
    </message>
    <message>
        <source>{0}: {1} {2} ({3}; {4}).</source>
        <translation>{0}:{1} {2}({3};{4})。</translation>
    </message>
    <message>
        <source>The cast was designed with {0}° of draft; {1} usually asks for {2}° ({3}).</source>
        <translation>铸件按 {0}° 斜度设计;{1} 通常要求 {2}°({3})。</translation>
    </message>
    <message>
        <source>sourced</source>
        <translation>有来源</translation>
    </message>
    <message>
        <source>no source</source>
        <translation>无来源</translation>
    </message>
    <message>
        <source>make a coupon</source>
        <translation>需浇铸试样</translation>
    </message>
    <message>
        <source>ask the data sheet</source>
        <translation>查阅数据表</translation>
    </message>
    <message>
        <source>sources disagree</source>
        <translation>来源不一致</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS 塑料</translation>
    </message>
    <message>
        <source>Polypropylene</source>
        <translation>聚丙烯</translation>
    </message>
    <message>
        <source>HDPE</source>
        <translation>高密度聚乙烯</translation>
    </message>
    <message>
        <source>PA 66</source>
        <translation>尼龙 66</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>聚甲醛</translation>
    </message>
    <message>
        <source>Polycarbonate</source>
        <translation>聚碳酸酯</translation>
    </message>
    <message>
        <source>PMMA</source>
        <translation>有机玻璃</translation>
    </message>
    <message>
        <source>Polystyrene</source>
        <translation>聚苯乙烯</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>铝</translation>
    </message>
    <message>
        <source>Zinc alloy</source>
        <translation>锌合金</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>青铜</translation>
    </message>
    <message>
        <source>Grey iron</source>
        <translation>灰铸铁</translation>
    </message>
    <message>
        <source>Silicone (LSR)</source>
        <translation>硅胶 (LSR)</translation>
    </message>
    <message>
        <source>Polyurethane resin</source>
        <translation>聚氨酯树脂</translation>
    </message>
    <message>
        <source>Polyurethane foam</source>
        <translation>聚氨酯泡沫</translation>
    </message>
    <message>
        <source>Plaster</source>
        <translation>石膏</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>蜡</translation>
    </message>
    <message>
        <source>Concrete</source>
        <translation>混凝土</translation>
    </message>
    <message>
        <source>Chocolate</source>
        <translation>巧克力</translation>
    </message>
    <message>
        <source>Gummy candy</source>
        <translation>软糖</translation>
    </message>
    <message>
        <source>injection</source>
        <translation>注塑</translation>
    </message>
    <message>
        <source>gravity, permanent mold</source>
        <translation>重力铸造,永久模</translation>
    </message>
    <message>
        <source>die casting</source>
        <translation>压铸</translation>
    </message>
    <message>
        <source>sand</source>
        <translation>砂型铸造</translation>
    </message>
    <message>
        <source>pour or injection</source>
        <translation>浇注或注射</translation>
    </message>
    <message>
        <source>pour</source>
        <translation>浇注</translation>
    </message>
    <message>
        <source>mold makers' shrink charts (mfgabc.com, techni-mold.com)</source>
        <translation>模具厂收缩率表 (mfgabc.com, techni-mold.com)</translation>
    </message>
    <message>
        <source>mold makers' guides: 1° usual, 0.5° least, 1.5° easy</source>
        <translation>模具厂指南:通常 1°,最小 0.5°,宽松 1.5°</translation>
    </message>
    <message>
        <source>makers' data sheets</source>
        <translation>厂商数据表</translation>
    </message>
    <message>
        <source>ptonline.com, viewmold.com</source>
        <translation>ptonline.com 与 viewmold.com</translation>
    </message>
    <message>
        <source>calculatoredge.com chart, foundry texts</source>
        <translation>calculatoredge.com 表格,铸造书籍</translation>
    </message>
    <message>
        <source>permanent mold practice (dynacast.com, watry.com); die casting 2°</source>
        <translation>永久模经验 (dynacast.com, watry.com);压铸 2°</translation>
    </message>
    <message>
        <source>tables of metals</source>
        <translation>金属表</translation>
    </message>
    <message>
        <source>dynacast.com</source>
        <translation>dynacast.com 资料</translation>
    </message>
    <message>
        <source>foundry practice</source>
        <translation>铸造经验</translation>
    </message>
    <message>
        <source>silicone.pro</source>
        <translation>silicone.pro 资料</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>resin makers</source>
        <translation>树脂厂商</translation>
    </message>
    <message>
        <source>[Stein 2019]</source>
        <translation>依据 [Stein 2019]</translation>
    </message>
    <message>
        <source>foam makers</source>
        <translation>泡沫厂商</translation>
    </message>
    <message>
        <source>plaster tables</source>
        <translation>石膏表</translation>
    </message>
    <message>
        <source>measurements of beeswax</source>
        <translation>蜂蜡测量</translation>
    </message>
    <message>
        <source>tables</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>concrete tables</source>
        <translation>混凝土表</translation>
    </message>
    <message>
        <source>caststone.org</source>
        <translation>caststone.org 资料</translation>
    </message>
    <message>
        <source>a chocolate mold maker: about 1 % by volume</source>
        <translation>一家巧克力模具厂:约 1 % 体积</translation>
    </message>
    <message>
        <source>a chocolate mold maker</source>
        <translation>一家巧克力模具厂</translation>
    </message>
    <message>
        <source>0.4 to 0.9</source>
        <translation>0.4 至 0.9</translation>
    </message>
    <message>
        <source>1.0 to 2.5</source>
        <translation>1.0 至 2.5</translation>
    </message>
    <message>
        <source>0.025 to 0.038</source>
        <translation>0.025 至 0.038</translation>
    </message>
    <message>
        <source>0.013 to 0.030</source>
        <translation>0.013 至 0.030</translation>
    </message>
    <message>
        <source>0.008 to 0.013</source>
        <translation>0.008 至 0.013</translation>
    </message>
    <message>
        <source>1.25 to 1.8</source>
        <translation>1.25 至 1.8</translation>
    </message>
    <message>
        <source>-0.08 to -0.39</source>
        <translation>−0.08 至 −0.39</translation>
    </message>
    <message>
        <source>It expands: leave it a way to overflow.</source>
        <translation>它会膨胀:请留出溢流通道。</translation>
    </message>
    <message>
        <source>It expands while it sets.</source>
        <translation>凝固时会膨胀。</translation>
    </message>
    <message>
        <source>Poured hot.</source>
        <translation>趁热浇注。</translation>
    </message>
    <message>
        <source>Three layers of sealing agent on a printed mold.</source>
        <translation>打印模具上涂三层封闭剂。</translation>
    </message>
    <message>
        <source>One layer of release agent made for foam.</source>
        <translation>一层泡沫专用脱模剂。</translation>
    </message>
    <message>
        <source>Pour it in and close the mold; what it expands by leaves through the spout.</source>
        <translation>倒入后合模;膨胀部分从浇口溢出。</translation>
    </message>
    <message>
        <source>As the maker of the foam says: time and temperature differ from product to product.</source>
        <translation>按泡沫厂商说明:时间和温度因产品而异。</translation>
    </message>
    <message>
        <source>[Stein 2019], section 7</source>
        <translation>[Stein 2019] 第 7 节</translation>
    </message>
    <message>
        <source>Grease the mold with canola oil.</source>
        <translation>用菜籽油涂抹模具。</translation>
    </message>
    <message>
        <source>240 ml of grape juice, 4 tablespoons of sugar and 4 of gelatin, heated on low heat for about a minute until all is dissolved and the sugar is not brown; pour it in hot and press it into every corner.</source>
        <translation>240 ml 葡萄汁、4 汤匙糖和 4 汤匙明胶,小火加热约一分钟至全部溶解且糖不变褐;趁热倒入并压入每个角落。</translation>
    </message>
    <message>
        <source>About 3 hours in the fridge at 4 °C; then let it dry in the air. Sugar on it keeps it from sticking.</source>
        <translation>冰箱 4 °C 约 3 小时;然后晾干。撒糖可防粘。</translation>
    </message>
    <message>
        <source>[Stein 2019], A.2</source>
        <translation>[Stein 2019] 附录 A.2</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>Draft %1</source>
        <translation>拔模角 %1</translation>
    </message>
    <message>
        <source>thickness %1</source>
        <translation>厚度 %1</translation>
    </message>
    <message>
        <source>On the section</source>
        <translation>在剖面上</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
</context>
<context>
    <name>MessageDelegate</name>
    <message>
        <source>Show me</source>
        <translation>指给我看</translation>
    </message>
</context>
<context>
    <name>Mold</name>
    <message>
        <source>No mold can be built round this cast. {0} Finish the cast first.</source>
        <translation>无法围绕此铸件构建模具。{0} 请先完成铸件。</translation>
    </message>
    <message>
        <source>Building the mold was cancelled.</source>
        <translation>模具的构建已取消。</translation>
    </message>
    <message>
        <source>Writing the mold was cancelled.</source>
        <translation>模具的写出已取消。</translation>
    </message>
    <message>
        <source>The 3MF file could not be made: lib3mf failed to {0}.</source>
        <translation>无法生成 3MF 文件：lib3mf 未能 {0}。</translation>
    </message>
    <message>
        <source>A channel&apos;s wall would have to lie flat to leave along the removal directions with {0}°.</source>
        <translation>通道壁须完全放平，才能沿脱模方向以 {0}° 脱出。</translation>
    </message>
    <message>
        <source>A runner can only be {0} mm deep here, which is too little for the gates that open into it. Take a wider spout or narrower gates.</source>
        <translation>此处流道只能深 {0} mm，不足以容纳通入其中的浇口。请选用更宽的浇道或更窄的浇口。</translation>
    </message>
    <message>
        <source>Every second cavity cannot be turned: its faces would leave with {0}°, {1}° are required. Turned copies need removal directions normal to the plane.</source>
        <translation>无法把每隔一个的型腔旋转：其面只能以 {0}° 脱出，而要求为 {1}°。旋转的副本要求脱模方向垂直于分型面。</translation>
    </message>
    <message>
        <source>Every second cavity cannot be turned over: its faces would leave with {0}°, {1}° are required. That needs removal directions that the half-turn exchanges.</source>
        <translation>无法把每隔一个的型腔翻转：其面只能以 {0}° 脱出，而要求为 {1}°。这要求半周旋转能使两个脱模方向互换。</translation>
    </message>
    <message>
        <source>Every second cavity cannot be mirrored: its faces would leave with {0}°, {1}° are required. That needs removal directions in the mirror&apos;s plane.</source>
        <translation>无法把每隔一个的型腔镜像：其面只能以 {0}° 脱出，而要求为 {1}°。这要求脱模方向位于镜像平面内。</translation>
    </message>
    <message>
        <source>The channels could not be joined to the cavity soundly at any of {0} nearby places. Another pour direction or gate width may help.</source>
        <translation>在附近 {0} 个位置都无法把通道与型腔可靠地连接。换一个浇注方向或浇口宽度可能有用。</translation>
    </message>
    <message>
        <source>A gate {0} mm wide would be wider than the cavity where it is filled: there it is {1} mm wide.</source>
        <translation>宽 {0} 毫米的内浇口会比充填处的型腔更宽：该处内浇口宽 {1} 毫米。</translation>
    </message>
    <message>
        <source>The way from a cavity&apos;s gate to the runner passes through another part of the cavity. Choose another pour direction.</source>
        <translation>从型腔浇口到流道的路径穿过型腔的另一部分。请选择另一个浇注方向。</translation>
    </message>
    <message>
        <source>Vents need a spout: without one nothing tells which way is up while the mold is filled.</source>
        <translation>排气孔需要浇道：没有浇道就无法知道浇注时哪边朝上。</translation>
    </message>
    <message>
        <source>A shrink of {0} % is no shrink of a material: give less than 50 %.</source>
        <translation>{0} % 不是材料的收缩率：请给出小于 50 % 的值。</translation>
    </message>
    <message>
        <source>The parting face could not be built: features meet in the parting plane.</source>
        <translation>无法生成分型面：各特征在分型面上相交。</translation>
    </message>
    <message>
        <source>A wall at the parting plane would have to lie flat to leave along the removal directions with {0}°.</source>
        <translation>分型面处的壁须完全放平，才能沿脱模方向以 {0}° 脱出。</translation>
    </message>
    <message>
        <source>Only {0} of {1} ejector pins find a place in half {2}: a pin of {3} mm needs ground that is flat within 35°, away from the parting line and the gate. Ask for fewer or thinner pins, or the other half.</source>
        <translation>{1} 根顶针中只有 {0} 根能在半模 {2} 中找到位置：直径 {3} mm 的顶针需要 35° 以内的平坦面，并远离分型线和浇口。请减少数量、改用更细的顶针，或换另一半模。</translation>
    </message>
    <message>
        <source>A spout through half 1 finds no place: its neck of {0} mm has no room on the cavity there. Take a thinner neck, or let the mold stand.</source>
        <translation>穿过半模 1 的浇口找不到位置：直径 {0} mm 的颈部在型腔上没有空间。请使用更细的颈部，或让模具立放。</translation>
    </message>
    <message>
        <source>No block of the stock is large enough: the longest has {0} mm.</source>
        <translation>库存中没有足够大的模坯：最长的只有 {0} mm。</translation>
    </message>
    <message>
        <source>Ejector hole {0} cannot enter the cavity of half {1} there: a pin of {2} mm needs ground that is flat within 35°, {3} mm from the parting line.</source>
        <translation>顶针孔 {0} 不能在此处进入半模 {1} 的型腔：直径 {2} mm 的顶针需要 35° 以内的平坦面，并距分型线 {3} mm。</translation>
    </message>
    <message>
        <source>Spout {0} cannot enter its cavity there: its neck of {1} mm has no room, or the ground is steeper than 70°.</source>
        <translation>浇口 {0} 不能在此处进入型腔：其 {1} mm 的颈部放不下，或该处坡度超过 70°。</translation>
    </message>
    <message>
        <source>Vent {0} would stand beside the {1} mm³ of air that it is to let out. Keep it over them, or have it placed automatically.</source>
        <translation>排气 {0} 会偏离它要排出的 {1} mm³ 空气。请将其保持在空气上方，或自动放置。</translation>
    </message>
    <message>
        <source>Vent {0} has no way out of the cavity there: it needs room for a foot wholly inside the cast, and nothing in its way.</source>
        <translation>排气 {0} 在此处无法通出型腔：其底部须完全位于铸件之内，且路径上不得有阻挡。</translation>
    </message>
    <message>
        <source>At x = {0} mm the spout has no room between the gates beside it. Move it away from them.</source>
        <translation>在 x = {0} mm 处，浇口与旁边的浇道口之间没有空间。请将其移开。</translation>
    </message>
    <message>
        <source>At x = {0} mm a spout {1} mm wide does not meet the cavity&apos;s parting line from above, which reaches from {2} to {3} mm. Move it inwards, or make its end narrower.</source>
        <translation>在 x = {0} mm 处，宽 {1} mm 的浇口不能从上方接到型腔的分型线，后者的范围为 {2} 至 {3} mm。请向内移动，或收窄其末端。</translation>
    </message>
    <message>
        <source>There is no steel between {0} and {1}. Move one of them, or have it placed automatically.</source>
        <translation>{0} 与 {1} 之间没有钢材。请移动其中之一，或自动放置。</translation>
    </message>
    <message>
        <source>No feature can stand {0} mm from the middle: blocks of this mold reach no farther than {1} mm.</source>
        <translation>特征不能位于距中心 {0} mm 处：此模具的模块最远只到 {1} mm。</translation>
    </message>
    <message>
        <source>An outer face of the block would have to lie flat to have {0}° of draft along the removal directions.</source>
        <translation>模块的一个外壁须平放才能沿脱模方向具有 {0}° 的拔模角。</translation>
    </message>
    <message>
        <source>The block&apos;s outer faces meet before its back: take less draft.</source>
        <translation>模块外壁在到达背面之前相交：请减小拔模角。</translation>
    </message>
    <message>
        <source>Every second cavity can be another one in rows only, not on a circle or in a free layout.</source>
        <translation>只有成行排列时才能让每第二个型腔不同；圆形或自由排列时不行。</translation>
    </message>
    <message>
        <source>On a circle each cavity is filled at one place, from the middle. This cast is of {0} solids: arrange it in rows, or fill it through half 1.</source>
        <translation>在圆形排列中，每个型腔只从中心的一处充填。此铸件由 {0} 个实体组成：请成行排列，或经半模 1 充填。</translation>
    </message>
    <message>
        <source>Cavities {0} and {1} stand {2} mm apart; {3} mm of steel are asked for between them.</source>
        <translation>型腔 {0} 与 {1} 相距 {2} mm；其间要求 {3} mm 的壁厚。</translation>
    </message>
    <message>
        <source>The spout of cavity {0} passes too near to cavity {1} or its spout. Move one of them, or fill them through half 1.</source>
        <translation>型腔 {0} 的浇口离型腔 {1} 或其浇口太近。请移动其中之一，或经半模 1 充填。</translation>
    </message>
    <message>
        <source>A free layout needs at least one place for a cavity.</source>
        <translation>自由排列至少需要一个型腔位置。</translation>
    </message>
    <message>
        <source>Cavity {0} cannot be turned by {1}°: its faces would leave with {2}°, {3}° are required. Turned copies need removal directions normal to the plane.</source>
        <translation>型腔 {0} 不能旋转 {1}°：其表面将只有 {2}° 的拔模角，要求 {3}°。旋转的副本需要垂直于分型面的脱模方向。</translation>
    </message>
    <message>
        <source>Overflow {0} would stand {1} mm from its cavity's parting line. Keep it within {2} mm, or have it placed automatically.</source>
        <translation>溢料槽 {0} 距其型腔分型线 {1} mm。请保持在 {2} mm 以内，或让程序自动放置。</translation>
    </message>
    <message>
        <source>Overflow {0} cannot stand there: its channel would meet another part of the cavity. Move it, or have it placed automatically.</source>
        <translation>溢料槽 {0} 不能放在那里：其通道会碰到型腔的另一部分。请移动它，或让程序自动放置。</translation>
    </message>
    <message>
        <source>There is no room for {0} overflows {1} mm wide at each cavity. Ask for fewer or smaller ones, or for more steel between the cavities.</source>
        <translation>每个型腔旁没有空间放置 {0} 个宽 {1} mm 的溢料槽。请减少数量或尺寸，或增大型腔间的壁厚。</translation>
    </message>
    <message>
        <source>Overflow {0} would stand where the cavity is filled. Move it, or have it placed automatically.</source>
        <translation>溢料槽 {0} 位于型腔的进料处。请移动它，或让程序自动放置。</translation>
    </message>
    <message>
        <source>Overflows need a spout: without one nothing tells where material arrives last.</source>
        <translation>溢料槽需要浇道：没有浇道就无法知道材料最后到达哪里。</translation>
    </message>
    <message>
        <source>The channel of overflow {0} has no room in the wall of its well. Make the channel narrower or the well wider.</source>
        <translation>溢料槽 {0} 的通道在槽壁上没有空间。请减小通道宽度或增大槽的宽度。</translation>
    </message>
    <message>
        <source>A mold cannot lean by {0}° while it is filled: 0 to {1}° are possible.</source>
        <translation>浇注时模具不能倾斜 {0}°：可以为 0 到 {1}°。</translation>
    </message>
    <message>
        <source>There is no room for {0} keys, {1} slits, {2} bolt holes and {3} pockets. Ask for fewer or smaller ones.</source>
        <translation>放不下 {0} 个定位销、{1} 条撬模槽、{2} 个螺栓孔和 {3} 个嵌件槽。请减少数量或减小尺寸。</translation>
    </message>
    <message>
        <source>Measuring the steel was cancelled.</source>
        <translation>钢料厚度的测量已取消。</translation>
    </message>
    <message>
        <source>There is no letter &quot;{0}&quot; for a plaque. There are A to Z, 0 to 9, letters with Western marks, and - . , : / % ° # + ( ).</source>
        <translation>铭牌没有字符“{0}”。可用 A 至 Z、0 至 9、带西文变音符号的字母以及 - . , : / % ° # + ( )。</translation>
    </message>
    <message>
        <source>The plaque&apos;s text has no room on the back of half {0}, not even with letters of {1} mm. Take smaller letters, fewer words, more lines (| between them) or a larger block.</source>
        <translation>半模 {0} 的背面放不下铭牌文字，字高 {1} 毫米也不行。请减小字高、减少文字、增加行数（用 | 分隔）或加大模块。</translation>
    </message>
    <message>
        <source>Letters of {0} mm have strokes of {1} mm, and less than {2} mm cannot be printed or read. Make them {3} mm high or more.</source>
        <translation>字高 {0} 毫米时笔画宽 {1} 毫米，小于 {2} 毫米无法打印或辨认。请取 {3} 毫米或更高。</translation>
    </message>
    <message>
        <source>A plaque {0} mm deep leaves less than {1} mm of steel to the cavities. Make it shallower, or floor and ceiling thicker.</source>
        <translation>铭牌深 {0} 毫米，到型腔的钢料不足 {1} 毫米。请减小深度，或加厚底部和顶部。</translation>
    </message>
    <message>
        <source>Letters of {0} mm are too small for a plaque {1} mm deep: their walls meet. Make it shallower, or them larger.</source>
        <translation>字高 {0} 毫米对深 {1} 毫米的铭牌太小：槽壁会相交。请减小深度或加大字高。</translation>
    </message>
    <message>
        <source>Pockets {0} mm deep leave less than {1} mm of steel at the back of half {2}. Make them shallower, or the half thicker.</source>
        <translation>槽深 {0} 毫米时，半模 {2} 背面的钢料不足 {1} 毫米。请减小槽深，或加厚该半模。</translation>
    </message>
    <message>
        <source>The cavities do not fill at the same time: the ways to them are {0} to {1} mm long.</source>
        <translation>各型腔不会同时充满：到它们的流程长 {0} 至 {1} 毫米。</translation>
    </message>
    <message>
        <source>The spout stands at x = {0} mm, not where it was put: only from there all ways to the cavities are of one length. It can be moved where rows have the shortest runners.</source>
        <translation>浇口位于 x = {0} 毫米处，而不在手动放置的位置：只有从该处到各型腔的流程才等长。采用最短流道的成排布局中可以移动它。</translation>
    </message>
    <message>
        <source>Its walls lean up to {0}°: with less it would hold when one half is opened first.</source>
        <translation>其壁面倾斜达 {0}°：再小的话，先打开一半时会被卡住。</translation>
    </message>
    <message>
        <source>No vent can be placed here, or none that reaches higher.</source>
        <translation>此处无法设置排气，或没有更高的排气。</translation>
    </message>
    <message>
        <source>Widens outwards: it breaks off at its neck when half 1 is taken off, and is pushed out of it outwards.</source>
        <translation>向外变宽：取下半模 1 时在颈部断开，再从半模中向外推出。</translation>
    </message>
    <message>
        <source>Reads: {0}</source>
        <translation>文字：{0}</translation>
    </message>
    <message>
        <source>Each spout through half 1 holds its sprue and breaks off at a neck of {0} mm: the cast is proved without it. Push the sprues out of half 1 outwards.</source>
        <translation>穿过半模 1 的每个浇口会留住其料把，并在 {0} 毫米的颈部断开：铸件的证明不含料把。请从半模 1 向外推出料把。</translation>
    </message>
    <message>
        <source>Only {0} mm of steel between {1} and {2}.</source>
        <translation>{1} 与 {2} 之间的钢料只有 {0} 毫米。</translation>
    </message>
    <message>
        <source>Half {0} of {1} is larger than the printer&apos;s {2}.</source>
        <translation>半模 {0}（{1}）大于打印机的 {2}。</translation>
    </message>
    <message>
        <source>The mold needs {0} kN to stay closed; the press has {1} kN.</source>
        <translation>模具需要 {0} kN 才能保持闭合；压机只有 {1} kN。</translation>
    </message>
    <message>
        <source>Shrinking differently along the axes turns faces: the draft falls to {0}°. Design the cast with {1}°.</source>
        <translation>各轴收缩率不同会使面转动：拔模角降到 {0}°。请按 {1}° 设计铸件。</translation>
    </message>
    <message>
        <source>The removal directions do not allow turned copies: on the circle they are only moved, and each is filled on another of its sides.</source>
        <translation>脱模方向不允许旋转副本：在圆周上它们只作平移，每个从不同的一侧充填。</translation>
    </message>
    <message>
        <source>While it is filled the mold is tilted by {0}° towards {1}: {2} mm³ of air stay instead of {3}.</source>
        <translation>充填时模具向{1}倾斜 {0}°：残留空气 {2} mm³，而不是 {3} mm³。</translation>
    </message>
    <message>
        <source>Tilt the mold by {0}° towards {1} while it is filled: trapped air falls from {3} to {2} mm³.</source>
        <translation>充填时请将模具向{1}倾斜 {0}°：残留空气由 {3} 降到 {2} mm³。</translation>
    </message>
    <message>
        <source>Balanced runners part in two at each joint: rows and columns must each be 1, 2, 4, 8 or another power of two. Here there are {0} and {1}.</source>
        <translation>平衡流道在每个接点一分为二：行数和列数都必须是 1、2、4、8 或其他 2 的幂。这里分别是 {0} 和 {1}。</translation>
    </message>
    <message>
        <source>Balanced runners lead along straight columns: they need a grid, not rows that are moved against each other.</source>
        <translation>平衡流道沿直列布置：需要网格排列，而不是相互错开的行。</translation>
    </message>
    <message>
        <source>Balanced runners fill each cavity at one place. This cast is of {0} solids: take the shortest runners, or fill it through half 1.</source>
        <translation>平衡流道在一处充填每个型腔。此铸件由 {0} 个实体组成：请采用最短流道，或通过半模 1 充填。</translation>
    </message>
    <message>
        <source>The gates of every second cavity stand too far aside for runners of one length. Take copies that are all alike, or the shortest runners.</source>
        <translation>每隔一个型腔的浇口偏得太远，无法做成等长流道。请采用完全相同的型腔，或最短流道。</translation>
    </message>
    <message>
        <source>A mold cannot have {0} cavities of {1}: 1 to {2} are possible.</source>
        <translation>模具不能有 {0} 个 {1} 的型腔：可为 1 至 {2} 个。</translation>
    </message>
    <message>
        <source>The free layout has {0} places; the parts of this mold ask for {1}.</source>
        <translation>自由排列有 {0} 个位置；此模具的零件需要 {1} 个。</translation>
    </message>
    <message>
        <source>{0} cannot stand in this mold: along the mold&apos;s removal directions its faces would leave with {1}° at best, {2}° are required. Design both parts with directions normal to the plane, or with the same ones.</source>
        <translation>{0} 不能放在此模具中：沿模具的脱模方向，其表面最多只有 {1}° 的拔模角，要求 {2}°。请让两个零件都采用垂直于分型面的方向，或采用相同的方向。</translation>
    </message>
    <message>
        <source>{0} cannot stand in this mold. {1} Finish its cast first.</source>
        <translation>{0} 不能放在此模具中。{1} 请先完成其铸件。</translation>
    </message>
    <message>
        <source>Every second cavity can be another one only where all are of one part.</source>
        <translation>只有所有型腔属于同一零件时，才能让每第二个型腔不同。</translation>
    </message>
    <message>
        <source>The layout has {0} × {1} cavities instead of {2} × {3}, so that each part has its number.</source>
        <translation>排列有 {0} × {1} 个型腔，而不是 {2} × {3} 个，使每个零件达到其数量。</translation>
    </message>
    <message>
        <source>A channel {0} mm deep closes before its floor: it is too narrow for the lean that its walls need. Make it wider, or take less draft.</source>
        <translation>深 {0} mm 的通道在到底之前就已合拢：按壁所需的斜度，它太窄了。请加宽它，或减小拔模斜度。</translation>
    </message>
    <message>
        <source>A key {0} mm wide whose walls lean {1}° comes to a point before it is {2} mm high. Make it wider, lower, or its draft smaller.</source>
        <translation>宽 {0} mm、侧壁倾斜 {1}° 的定位销在达到 {2} mm 高之前就已收成尖。请加宽、降低，或减小其斜度。</translation>
    </message>
    <message>
        <source>A wedge slit of {0} by {1} mm cannot be {2} mm high in each half with the draft that its walls need. Make it lower, or larger.</source>
        <translation>{0} × {1} mm 的撬模槽按壁所需的斜度，无法在每半模中做到 {2} mm 高。请降低或加大它。</translation>
    </message>
    <message>
        <source>A pocket's wall would have to lie flat to leave along the removal directions with {0}°.</source>
        <translation>嵌件槽的壁必须放平，才能以 {0}° 沿脱模方向脱出。</translation>
    </message>
    <message>
        <source>There is no steel between {0} and {1}. Give the cavities more spacing, or take fewer or smaller features.</source>
        <translation>{0} 与 {1} 之间没有钢料。请加大型腔间距，或减少、缩小特征。</translation>
    </message>
    <message>
        <source>{0} meets the same of the next cavity. Give the cavities more spacing, or make it smaller.</source>
        <translation>{0} 与相邻型腔的同一特征相碰。请加大型腔间距，或将其缩小。</translation>
    </message>
</context>
<context>
    <name>MoldFeaturePages</name>
    <message>
        <source>Drag its disc in the view, or type here.</source>
        <translation>在视图中拖动其圆点，或在此输入。</translation>
    </message>
    <message>
        <source>Place in the parting plane</source>
        <translation>在分型面中的位置</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Of the block, seen from half 1.</source>
        <translation>模块的侧面，从半模 1 看。</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>沿边缘</translation>
    </message>
    <message>
        <source>From the middle of the mold.</source>
        <translation>从模具中心起。</translation>
    </message>
    <message>
        <source>From the middle of the mold; up is where it is filled.</source>
        <translation>从模具中心起；上方为浇注处。</translation>
    </message>
    <message>
        <source>From the middle of its cavity; up is where it is filled.</source>
        <translation>从其型腔中心起；上方为浇注处。</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>放置</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>最薄钢材</translation>
    </message>
    <message>
        <source>Between this and the nearest other feature or face of the block.</source>
        <translation>与最近的其他特征或模块表面之间。</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>automatically</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>All: %1</source>
        <translation>全部:%1</translation>
    </message>
</context>
<context>
    <name>MoldPages</name>
    <message>
        <source>Block</source>
        <translation>模块</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁厚</translation>
    </message>
    <message>
        <source>Steel between the cavities and each side face.</source>
        <translation>型腔与各侧面之间的钢料。</translation>
    </message>
    <message>
        <source>Over half 1</source>
        <translation>半模 1 之上</translation>
    </message>
    <message>
        <source>Steel over the cavities of half 1.</source>
        <translation>半模 1 型腔上方的钢料。</translation>
    </message>
    <message>
        <source>Under half 2</source>
        <translation>半模 2 之下</translation>
    </message>
    <message>
        <source>Steel under the cavities of half 2.</source>
        <translation>半模 2 型腔下方的钢料。</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>型腔</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>并排</translation>
    </message>
    <message>
        <source>Cavities in a row.</source>
        <translation>每行的型腔数。</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Rows of cavities.</source>
        <translation>型腔的行数。</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>排列</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Staggered</source>
        <translation>交错</translation>
    </message>
    <message>
        <source>Packed</source>
        <translation>紧密</translation>
    </message>
    <message>
        <source>Steel between</source>
        <translation>间隔钢料</translation>
    </message>
    <message>
        <source>Between cavities, and between them and channels.</source>
        <translation>型腔之间，以及型腔与流道之间。</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>收缩率</translation>
    </message>
    <message>
        <source>Made larger by</source>
        <translation>放大系数</translation>
    </message>
    <message>
        <source>Both are in use; at 5 % they are 1.0500 and 1.0526. The report says which.</source>
        <translation>两种都在使用；5 % 时分别为 1.0500 和 1.0526。报告中会注明。</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>浇注</translation>
    </message>
    <message>
        <source>Spout</source>
        <translation>浇口</translation>
    </message>
    <message>
        <source>In the parting plane for a mold that stands on its edge; through half 1 for one that lies flat: that one breaks off at its neck.</source>
        <translation>立放的模具在分型面内；平放的模具穿过半模 1，并在颈部折断。</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>In the parting plane</source>
        <translation>在分型面内</translation>
    </message>
    <message>
        <source>Through half 1</source>
        <translation>穿过半模 1</translation>
    </message>
    <message>
        <source>Spout&apos;s width</source>
        <translation>浇口宽度</translation>
    </message>
    <message>
        <source>In the parting plane; of one through half 1, above its neck.</source>
        <translation>在分型面内；穿过半模 1 时为颈部上方。</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>颈部</translation>
    </message>
    <message>
        <source>Where a spout through half 1 breaks off.</source>
        <translation>穿过半模 1 的浇口在此折断。</translation>
    </message>
    <message>
        <source>Vents</source>
        <translation>排气</translation>
    </message>
    <message>
        <source>Where air would stay while the mold is filled.</source>
        <translation>浇注时空气会滞留之处。</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Cast hollow</source>
        <translation>空心浇铸</translation>
    </message>
    <message>
        <source>The wall that stays when the rest is poured out again; 0: solid.</source>
        <translation>倒出其余材料后留下的壁厚；0 表示实心。</translation>
    </message>
    <message>
        <source>Closing and opening</source>
        <translation>合模与开模</translation>
    </message>
    <message>
        <source>Registration keys</source>
        <translation>定位销</translation>
    </message>
    <message>
        <source>On half 2, in sockets of half 1; one is larger, so that the halves fit one way only.</source>
        <translation>位于半模 2，嵌入半模 1 的凹槽；其中一个较大，使两半只能以一种方式配合。</translation>
    </message>
    <message>
        <source>On all sides and in depth.</source>
        <translation>各侧及深度方向。</translation>
    </message>
    <message>
        <source>Wedge slits</source>
        <translation>撬模槽</translation>
    </message>
    <message>
        <source>Notches at the edge of the plane, to pry the halves apart.</source>
        <translation>分型面边缘的缺口，用于撬开两半。</translation>
    </message>
    <message>
        <source>Bolt holes</source>
        <translation>螺栓孔</translation>
    </message>
    <message>
        <source>Straight through both halves.</source>
        <translation>直穿两半。</translation>
    </message>
    <message>
        <source>Ejector holes</source>
        <translation>顶针孔</translation>
    </message>
    <message>
        <source>For each cavity.</source>
        <translation>每个型腔。</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过时</translation>
    </message>
    <message>
        <source>proved</source>
        <translation>已证明</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>模具</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>Half 1, mm</source>
        <translation>半模 1，mm</translation>
    </message>
    <message>
        <source>Half 2, mm</source>
        <translation>半模 2，mm</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>流道</translation>
    </message>
    <message>
        <source>Air that stays</source>
        <translation>滞留空气</translation>
    </message>
    <message>
        <source>Both halves</source>
        <translation>两个半模</translation>
    </message>
    <message>
        <source>Clamp force</source>
        <translation>锁模力</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>最薄钢材</translation>
    </message>
    <message>
        <source>Comes off</source>
        <translation>可脱开</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>外形</translation>
    </message>
    <message>
        <source>A box, or a shell that saves material: what holds nothing is cut away from its corners.</source>
        <translation>方块，或节省材料的壳体：角部不含任何结构的部分被切去。</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>方块</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>壳体</translation>
    </message>
    <message>
        <source>Outer draft</source>
        <translation>外壁拔模</translation>
    </message>
    <message>
        <source>The outer faces widen to the back by this, so that a half that is cast leaves its form; below 0 they narrow.</source>
        <translation>外壁向背面按此角度扩大，使浇铸成形的半模能脱出其型框；小于 0 则收窄。</translation>
    </message>
    <message>
        <source>What the printer can make; a half that is larger is told of. 0: not known.</source>
        <translation>打印机能制作的尺寸；更大的半模会被提示。0：未知。</translation>
    </message>
    <message>
        <source>Stock and machines</source>
        <translation>坯料与设备</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>坯料</translation>
    </message>
    <message>
        <source>Lengths and widths of blocks that are to be had, in mm, a comma between; the next is taken. Empty: any.</source>
        <translation>现有坯料的长宽（毫米），用逗号分隔；取下一个够大的。留空：不限。</translation>
    </message>
    <message>
        <source>Printer&apos;s width</source>
        <translation>打印机宽度</translation>
    </message>
    <message>
        <source>Printer&apos;s depth</source>
        <translation>打印机深度</translation>
    </message>
    <message>
        <source>Printer&apos;s height</source>
        <translation>打印机高度</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>压机</translation>
    </message>
    <message>
        <source>What it closes with; a mold that needs more is told of. 0: not known.</source>
        <translation>合模力；需要更大合模力的模具会被提示。0：未知。</translation>
    </message>
    <message>
        <source>By how much the material shrinks; the cavity is made larger by it. The same along all axes of the part until y or z differ, then along x. Less than 0: it expands.</source>
        <translation>材料的收缩率；型腔按此放大。在 y 或 z 不同之前沿零件各轴相同，之后仅沿 x。小于 0：膨胀。</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>沿 y</translation>
    </message>
    <message>
        <source>Shrink along y of the part.</source>
        <translation>沿零件 y 轴的收缩率。</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>沿 z</translation>
    </message>
    <message>
        <source>Shrink along z of the part.</source>
        <translation>沿零件 z 轴的收缩率。</translation>
    </message>
    <message>
        <source>Vents&apos; depth</source>
        <translation>排气槽深度</translation>
    </message>
    <message>
        <source>In the parting plane, both halves together; 0: as their width asks.</source>
        <translation>在分型面上，两半合计；0：按宽度确定。</translation>
    </message>
    <message>
        <source>How rows lie to each other. Packed: as close as the outlines allow. Circle: about a spout in their middle, each filled over a way of the same length. Free: at the places given.</source>
        <translation>各行的相对位置。紧密：按轮廓允许的最近距离。圆形：围绕中心浇口，各型腔的流道等长。自由：在给定位置。</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Of a free layout: x and y of each cavity in mm and how far it is turned in degrees; a semicolon between cavities.</source>
        <translation>自由排列：每个型腔的 x 和 y（mm）及旋转角度（度）；型腔之间用分号。</translation>
    </message>
    <message>
        <source>Overflows</source>
        <translation>溢料槽</translation>
    </message>
    <message>
        <source>Closed wells beside each solid of each cavity, for the material that arrives last.</source>
        <translation>每个型腔的每个实体旁的封闭槽，用来容纳最后到达的材料。</translation>
    </message>
    <message>
        <source>0.3 of the well's at most.</source>
        <translation>最多为槽宽的 0.3 倍。</translation>
    </message>
    <message>
        <source>From the cavity to the well.</source>
        <translation>从型腔到槽。</translation>
    </message>
    <message>
        <source>Tilted</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>While it is filled: by number, or as the least air stays. What that would save is told when the mold is built.</source>
        <translation>浇注时：按数值，或使残留空气最少。构建模具时会告知可减少多少。</translation>
    </message>
    <message>
        <source>By number</source>
        <translation>按数值</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>倾角</translation>
    </message>
    <message>
        <source>How far the mold's top leans while it is filled, where that is by number.</source>
        <translation>按数值时，浇注时模具顶部倾斜的角度。</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>0 to the right, 90 to half 1, or to the back of a mold that lies flat.</source>
        <translation>0 朝右，90 朝半模 1；平放的模具则朝后。</translation>
    </message>
    <message>
        <source>Insert pockets</source>
        <translation>嵌件槽</translation>
    </message>
    <message>
        <source>In the parting face, for nuts, magnets or dowels.</source>
        <translation>位于分型面上，用于螺母、磁铁或销钉。</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>嵌件</translation>
    </message>
    <message>
        <source>Its shape, seen along the normal.</source>
        <translation>沿法线方向看的形状。</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Hexagon</source>
        <translation>六角形</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>嵌件宽度</translation>
    </message>
    <message>
        <source>Diameter, across flats, or the side along y.</source>
        <translation>直径、对边宽度或沿 y 的边长。</translation>
    </message>
    <message>
        <source>Its length</source>
        <translation>嵌件长度</translation>
    </message>
    <message>
        <source>The side along x, of a rectangle.</source>
        <translation>矩形沿 x 的边长。</translation>
    </message>
    <message>
        <source>Pockets&apos; depth</source>
        <translation>槽深</translation>
    </message>
    <message>
        <source>Into the half.</source>
        <translation>深入半模的深度。</translation>
    </message>
    <message>
        <source>Pockets&apos; clearance</source>
        <translation>槽间隙</translation>
    </message>
    <message>
        <source>Round the insert, at the pocket&apos;s floor.</source>
        <translation>槽底处嵌件四周的间隙。</translation>
    </message>
    <message>
        <source>Pockets in</source>
        <translation>槽位于</translation>
    </message>
    <message>
        <source>Dowels ask for both halves.</source>
        <translation>销钉需要两半都有槽。</translation>
    </message>
    <message>
        <source>Half 1</source>
        <translation>半模 1</translation>
    </message>
    <message>
        <source>Half 2</source>
        <translation>半模 2</translation>
    </message>
    <message>
        <source>Plaque</source>
        <translation>铭牌</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Letters&apos; height</source>
        <translation>字高</translation>
    </message>
    <message>
        <source>Of capitals, 2.8 mm or more; 0: as large as there is room for.</source>
        <translation>大写字母高度，至少 2.8 毫米；0：按可用空间取最大。</translation>
    </message>
    <message>
        <source>Letters&apos; depth</source>
        <translation>字深</translation>
    </message>
    <message>
        <source>Of their grooves.</source>
        <translation>刻槽的深度。</translation>
    </message>
    <message>
        <source>Halves 1 and 2</source>
        <translation>半模 1 和 2</translation>
    </message>
    <message>
        <source>Runners</source>
        <translation>流道</translation>
    </message>
    <message>
        <source>From a spout in the parting plane to cavities in rows and columns: the shortest, or all ways equally long, so that the cavities fill together.</source>
        <translation>从分型面内的浇道到成行成列的型腔：最短，或所有路径等长，使各型腔同时充满。</translation>
    </message>
    <message>
        <source>Shortest</source>
        <translation>最短</translation>
    </message>
    <message>
        <source>Equally long</source>
        <translation>等长</translation>
    </message>
    <message>
        <source>Least steel</source>
        <translation>最小钢厚</translation>
    </message>
    <message>
        <source>Between any two features; what the program places keeps it, and less is told of.</source>
        <translation>任意两个特征之间;程序放置时遵守,不足时提示。</translation>
    </message>
    <message>
        <source>Sizes round up to</source>
        <translation>尺寸向上取整到</translation>
    </message>
    <message>
        <source>Multiples of this; 0: they are as they come out.</source>
        <translation>此值的倍数;0:不取整。</translation>
    </message>
    <message>
        <source>Every second</source>
        <translation>每隔一个</translation>
    </message>
    <message>
        <source>Cavity of a row. Turned: about the plane's normal. Turned over: the halves swap. Mirrored: the opposite-handed part. What the directions do not allow is refused.</source>
        <translation>一行中的型腔。旋转:绕平面法线。翻转:两半互换。镜像:相反手性的零件。方向不允许的会被拒绝。</translation>
    </message>
    <message>
        <source>The same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Turned over</source>
        <translation>翻转</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Of the point of the part that stays where it is.</source>
        <translation>零件上保持不动的点。</translation>
    </message>
    <message>
        <source>Shrink and density</source>
        <translation>收缩率与密度</translation>
    </message>
    <message>
        <source>Origin x</source>
        <translation>原点 x</translation>
    </message>
    <message>
        <source>Origin y</source>
        <translation>原点 y</translation>
    </message>
    <message>
        <source>Origin z</source>
        <translation>原点 z</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Of what is cast, for its mass. 0: not known.</source>
        <translation>浇铸物的密度,用于计算质量。0:未知。</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>In the cavity while it is filled, for the clamp force.</source>
        <translation>填充时型腔内压力,用于锁模力。</translation>
    </message>
    <message>
        <source>Block's density</source>
        <translation>模块密度</translation>
    </message>
    <message>
        <source>Of what the halves are made of, for their mass. 0: not known.</source>
        <translation>两半所用材料的密度,用于计算质量。0:未知。</translation>
    </message>
    <message>
        <source>Gate's width</source>
        <translation>浇道口宽度</translation>
    </message>
    <message>
        <source>Where a channel in the parting plane meets the cavity.</source>
        <translation>分型面内流道与型腔相接处。</translation>
    </message>
    <message>
        <source>Funnel's width</source>
        <translation>漏斗宽度</translation>
    </message>
    <message>
        <source>At the block's face.</source>
        <translation>在模块表面处。</translation>
    </message>
    <message>
        <source>Channels' draft</source>
        <translation>流道斜度</translation>
    </message>
    <message>
        <source>Of spouts, runners and gates; more where the directions ask for it.</source>
        <translation>浇口、流道和浇道口;方向要求时更大。</translation>
    </message>
    <message>
        <source>Vents' width</source>
        <translation>排气槽宽度</translation>
    </message>
    <message>
        <source>At the narrowest.</source>
        <translation>最窄处。</translation>
    </message>
    <message>
        <source>Air that may stay</source>
        <translation>允许残留的空气</translation>
    </message>
    <message>
        <source>A place where less than this stays gets no vent.</source>
        <translation>残留少于此值处不设排气。</translation>
    </message>
    <message>
        <source>Keys' width</source>
        <translation>定位销宽度</translation>
    </message>
    <message>
        <source>At the parting plane.</source>
        <translation>在分型面处。</translation>
    </message>
    <message>
        <source>Keys' height</source>
        <translation>定位销高度</translation>
    </message>
    <message>
        <source>Over the parting plane.</source>
        <translation>高出分型面。</translation>
    </message>
    <message>
        <source>Keys' clearance</source>
        <translation>定位销间隙</translation>
    </message>
    <message>
        <source>Keys' draft</source>
        <translation>定位销斜度</translation>
    </message>
    <message>
        <source>Against both opening orders; more where the mold's draft is more.</source>
        <translation>针对两种开模顺序;模具斜度更大时取更大。</translation>
    </message>
    <message>
        <source>First is larger by</source>
        <translation>第一个大</translation>
    </message>
    <message>
        <source>So that the halves fit one way only.</source>
        <translation>使两半只能以一种方式合模。</translation>
    </message>
    <message>
        <source>Slits' depth</source>
        <translation>撬模槽深度</translation>
    </message>
    <message>
        <source>Into the block.</source>
        <translation>深入模块。</translation>
    </message>
    <message>
        <source>Slits' width</source>
        <translation>撬模槽宽度</translation>
    </message>
    <message>
        <source>Along the block's face.</source>
        <translation>沿模块表面。</translation>
    </message>
    <message>
        <source>Slits' height</source>
        <translation>撬模槽高度</translation>
    </message>
    <message>
        <source>In each half.</source>
        <translation>每一半中。</translation>
    </message>
    <message>
        <source>Holes' width</source>
        <translation>孔径</translation>
    </message>
    <message>
        <source>An M6 bolt passes freely through 6.6 mm.</source>
        <translation>M6 螺栓可自由穿过 6.6 mm。</translation>
    </message>
    <message>
        <source>Steel outside</source>
        <translation>外侧钢厚</translation>
    </message>
    <message>
        <source>To the block's faces.</source>
        <translation>到模块表面。</translation>
    </message>
    <message>
        <source>Steel inside</source>
        <translation>内侧钢厚</translation>
    </message>
    <message>
        <source>To all that stands in the parting plane.</source>
        <translation>到分型面内的一切特征。</translation>
    </message>
    <message>
        <source>Pins' width</source>
        <translation>顶针直径</translation>
    </message>
    <message>
        <source>Of the ejector pins.</source>
        <translation>顶针的直径。</translation>
    </message>
    <message>
        <source>Pins in</source>
        <translation>顶针位于</translation>
    </message>
    <message>
        <source>The half that they pass through.</source>
        <translation>其穿过的一半。</translation>
    </message>
    <message>
        <source>Wells' width</source>
        <translation>溢料井宽度</translation>
    </message>
    <message>
        <source>Of overflows in the parting plane.</source>
        <translation>分型面内的溢料井。</translation>
    </message>
    <message>
        <source>Channels' width</source>
        <translation>通道宽度</translation>
    </message>
    <message>
        <source>Channels' length</source>
        <translation>通道长度</translation>
    </message>
    <message>
        <source>Spouts, runners, gates</source>
        <translation>浇口、流道、浇道口</translation>
    </message>
    <message>
        <source>Up while filled</source>
        <translation>填充时朝上</translation>
    </message>
    <message>
        <source>As a turn of the cast about the plane's normal; automatic: of four the one that keeps the least air.</source>
        <translation>铸件绕平面法线的转角;自动:四种中残留空气最少者。</translation>
    </message>
    <message>
        <source>Tilt while filled</source>
        <translation>填充时倾斜</translation>
    </message>
    <message>
        <source>Engraved in the back of each half; | between lines. {part}, {number}, {revision}, {half} and {shrink} are replaced; auto: all there is of them. Empty: none.</source>
        <translation>刻在每一半背面;行间用 |。{part}、{number}、{revision}、{half} 和 {shrink} 会被替换;auto:包含所有已有内容。空:无。</translation>
    </message>
</context>
<context>
    <name>MoldPlacing</name>
    <message>
        <source>the block&apos;s face</source>
        <translation>模块表面</translation>
    </message>
    <message>
        <source>cavity %1</source>
        <translation>型腔 %1</translation>
    </message>
    <message>
        <source>a runner</source>
        <translation>流道</translation>
    </message>
    <message>
        <source>a gate</source>
        <translation>浇道口</translation>
    </message>
    <message>
        <source>spout %1</source>
        <translation>浇口 %1</translation>
    </message>
    <message>
        <source>vent %1</source>
        <translation>排气 %1</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>定位销 %1</translation>
    </message>
    <message>
        <source>wedge slit %1</source>
        <translation>撬模槽 %1</translation>
    </message>
    <message>
        <source>bolt hole %1</source>
        <translation>螺栓孔 %1</translation>
    </message>
    <message>
        <source>ejector hole %1</source>
        <translation>顶针孔 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Place %1 automatically</source>
        <translation>自动放置 %1</translation>
    </message>
    <message>
        <source>Place all automatically</source>
        <translation>全部自动放置</translation>
    </message>
    <message>
        <source>Spout %1</source>
        <translation>浇口 %1</translation>
    </message>
    <message>
        <source>Vent %1</source>
        <translation>排气 %1</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>定位销 %1</translation>
    </message>
    <message>
        <source>Wedge slit %1</source>
        <translation>撬模槽 %1</translation>
    </message>
    <message>
        <source>Bolt hole %1</source>
        <translation>螺栓孔 %1</translation>
    </message>
    <message>
        <source>Ejector hole %1</source>
        <translation>顶针孔 %1</translation>
    </message>
    <message>
        <source>No steel to %1, %2 mm asked for</source>
        <translation>到%1没有钢材，要求 %2 mm</translation>
    </message>
    <message>
        <source>%1 mm of steel to %2, %3 asked for</source>
        <translation>到%2的钢材 %1 mm，要求 %3</translation>
    </message>
    <message>
        <source>%1 mm of steel to %2</source>
        <translation>到%2的钢材 %1 mm</translation>
    </message>
    <message>
        <source>overflow %1</source>
        <translation>溢料槽 %1</translation>
    </message>
    <message>
        <source>the channel of overflow %1</source>
        <translation>溢料槽 %1 的通道</translation>
    </message>
    <message>
        <source>Overflow %1</source>
        <translation>溢料槽 %1</translation>
    </message>
    <message>
        <source>Insert pocket %1</source>
        <translation>嵌件槽 %1</translation>
    </message>
    <message>
        <source>insert pocket %1</source>
        <translation>嵌件槽 %1</translation>
    </message>
    <message>
        <source>the plaque on half %1</source>
        <translation>半模 %1 的铭牌</translation>
    </message>
    <message>
        <source>Place %1 features automatically</source>
        <translation>自动放置 %1 个特征</translation>
    </message>
    <message>
        <source>block's face</source>
        <translation>模块表面</translation>
    </message>
</context>
<context>
    <name>ObstructionWords</name>
    <message>
        <source>Pocket of air</source>
        <translation>气穴</translation>
    </message>
    <message>
        <source>Closed piece</source>
        <translation>封闭块</translation>
    </message>
    <message>
        <source>Handle or arch</source>
        <translation>把手或拱</translation>
    </message>
    <message>
        <source>Linked pieces</source>
        <translation>相扣的块</translation>
    </message>
    <message>
        <source>Steep faces</source>
        <translation>过陡的面</translation>
    </message>
</context>
<context>
    <name>Pictures</name>
    <message>
        <source>Pictures cannot be drawn on this machine: OpenGL {0}.</source>
        <translation>此计算机无法绘制图片：OpenGL {0}。</translation>
    </message>
</context>
<context>
    <name>PinPages</name>
    <message>
        <source>Suggested</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Ends of limbs, where limbs meet, and points along the body.</source>
        <translation>肢端、肢体交汇处以及沿躯干的点。</translation>
    </message>
    <message>
        <source>Shown at most</source>
        <translation>最多显示</translation>
    </message>
    <message>
        <source>The best ones at this plane; those taken are no longer shown.</source>
        <translation>此平面下最好的点；已采用的不再显示。</translation>
    </message>
    <message>
        <source>Ends of limbs</source>
        <translation>肢端</translation>
    </message>
    <message>
        <source>Click a faint ring in the view to take it.</source>
        <translation>点击视图中的淡色圆环即可采用。</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>固定点</translation>
    </message>
    <message>
        <source>Hold points of the part on the parting plane.</source>
        <translation>把零件的点固定在分型面上。</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>手工设置</translation>
    </message>
    <message>
        <source>No pins yet. Where limbs curl, pins at their ends unroll them.</source>
        <translation>还没有固定点。肢体卷曲时，在其末端固定可把它展开。</translation>
    </message>
    <message>
        <source>Farthest from the plane</source>
        <translation>离平面最远</translation>
    </message>
    <message>
        <source>All pins</source>
        <translation>所有固定点</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Suggested pins</source>
        <translation>建议的固定点</translation>
    </message>
    <message>
        <source>Place in the part</source>
        <translation>在零件中的位置</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>To the plane</source>
        <translation>到平面</translation>
    </message>
    <message>
        <source>How far a run has to draw it, along the plane&apos;s normal.</source>
        <translation>运行须沿平面法线把它拉多远。</translation>
    </message>
    <message>
        <source>%1 to the plane</source>
        <translation>到平面 %1</translation>
    </message>
    <message>
        <source>%1 pins</source>
        <translation>%1 个固定点</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动%1</translation>
    </message>
    <message>
        <source>Move %1 pins</source>
        <translation>移动 %1 个固定点</translation>
    </message>
</context>
<context>
    <name>Presentation</name>
    <message>
        <source>1 pin</source>
        <translation>1 个固定点</translation>
    </message>
    <message>
        <source>%1 pins</source>
        <translation>%1 个固定点</translation>
    </message>
    <message>
        <source>Found by the run</source>
        <translation>由运行找到</translation>
    </message>
    <message>
        <source>Not chosen yet</source>
        <translation>尚未选择</translation>
    </message>
    <message>
        <source>Number %1 of %2</source>
        <translation>第 %1 个，共 %2 个</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>已选择</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Running, step %1</source>
        <translation>运行中，第 %1 步</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Obstructed</source>
        <translation>受阻</translation>
    </message>
    <message>
        <source>Ready to run</source>
        <translation>可以运行</translation>
    </message>
    <message>
        <source>Not started</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>Not castable yet</source>
        <translation>尚不可铸造</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>已过时</translation>
    </message>
    <message>
        <source>Waits for Deform</source>
        <translation>等待变形</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>正在检查</translation>
    </message>
    <message>
        <source>Proved at %1</source>
        <translation>已证明 %1</translation>
    </message>
    <message>
        <source>Not proved</source>
        <translation>未证明</translation>
    </message>
    <message>
        <source>Proved</source>
        <translation>已证明</translation>
    </message>
    <message>
        <source>%1 to level</source>
        <translation>与水平成 %1</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 个面</translation>
    </message>
    <message>
        <source>Parting plane</source>
        <translation>分型面</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>方向 %1</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>变形</translation>
    </message>
    <message>
        <source>will be filled</source>
        <translation>将被填充</translation>
    </message>
    <message>
        <source>Cast</source>
        <translation>铸件</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>模具</translation>
    </message>
    <message>
        <source>Half %1</source>
        <translation>半模 %1</translation>
    </message>
    <message>
        <source>%1, closed</source>
        <translation>%1，封闭</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>可以打印</translation>
    </message>
    <message>
        <source>No part open</source>
        <translation>没有打开零件</translation>
    </message>
    <message>
        <source>Open a mesh or a sample</source>
        <translation>请打开网格或示例</translation>
    </message>
    <message>
        <source>Castable and opens</source>
        <translation>可铸造且可开模</translation>
    </message>
    <message>
        <source>Cast and halves proved at %1 draft</source>
        <translation>铸件与半模已证明拔模角 %1</translation>
    </message>
    <message>
        <source>Castable</source>
        <translation>可铸造</translation>
    </message>
    <message>
        <source>Proved at %1 draft, %2 required</source>
        <translation>已证明拔模角 %1，要求 %2</translation>
    </message>
    <message>
        <source>Cannot be cast yet</source>
        <translation>还不能铸造</translation>
    </message>
    <message>
        <source>One obstruction at this plane</source>
        <translation>此平面有一处障碍</translation>
    </message>
    <message>
        <source>%1 obstructions at this plane</source>
        <translation>此平面有 %1 处障碍</translation>
    </message>
    <message>
        <source>Measuring the draft</source>
        <translation>正在测量拔模角</translation>
    </message>
    <message>
        <source>%1 of the surface below %2</source>
        <translation>%1 的表面低于 %2</translation>
    </message>
    <message>
        <source>No undercut seen; Run proves it</source>
        <translation>未见倒扣；运行加以证明</translation>
    </message>
    <message>
        <source>Part as opened</source>
        <translation>打开时的零件</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>正在开始</translation>
    </message>
    <message>
        <source>Step %1, paused</source>
        <translation>第 %1 步，已暂停</translation>
    </message>
    <message>
        <source>Step %1, live</source>
        <translation>第 %1 步，实时</translation>
    </message>
    <message>
        <source>1 region</source>
        <translation>1 个区域</translation>
    </message>
    <message>
        <source>%1 regions</source>
        <translation>%1 个区域</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Step %1 of the last run</source>
        <translation>上次运行的第 %1 步</translation>
    </message>
    <message>
        <source>Step %1 in view</source>
        <translation>显示第 %1 步</translation>
    </message>
    <message>
        <source>As read</source>
        <translation>读入时的状态</translation>
    </message>
    <message>
        <source>Mold, proved</source>
        <translation>模具，已证明</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>The project file could not be put together.</source>
        <translation>无法组成项目文件。</translation>
    </message>
    <message>
        <source>The evaluation was cancelled.</source>
        <translation>评估已取消。</translation>
    </message>
    <message>
        <source>{0} is damaged: its part {1} is missing or cannot be read. Open an older copy of the project.</source>
        <translation>{0} 已损坏：其中的 {1} 部分缺失或无法读取。请打开项目的较早副本。</translation>
    </message>
    <message>
        <source>{0} was saved by a newer Moldwright. A program that reads format {1} is needed; this one reads up to {2}.</source>
        <translation>{0} 由更新的 Moldwright 保存。需要能读取格式 {1} 的程序；本程序最多读取到 {2}。</translation>
    </message>
    <message>
        <source>{0} is not a Moldwright project.</source>
        <translation>{0} 不是 Moldwright 项目。</translation>
    </message>
    <message>
        <source>{0} cannot be opened: {1}.</source>
        <translation>无法打开 {0}：{1}。</translation>
    </message>
    <message>
        <source>{0} is too large for a project file.</source>
        <translation>{0} 作为项目文件太大。</translation>
    </message>
    <message>
        <source>{0} cannot be read.</source>
        <translation>无法读取 {0}。</translation>
    </message>
    <message>
        <source>{0} has no variant {1}. It has: {2}.</source>
        <translation>{0} 中没有变型 {1}。其中有：{2}。</translation>
    </message>
    <message>
        <source>No folder can be made in {0}.</source>
        <translation>无法在 {0} 中创建文件夹。</translation>
    </message>
    <message>
        <source>{0} holds no finished cast. Run its design to the end and save it first.</source>
        <translation>{0} 中没有已完成的铸件。请先完成其设计运行并保存。</translation>
    </message>
</context>
<context>
    <name>PropertyPages</name>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Draft required</source>
        <translation>要求的拔模角</translation>
    </message>
    <message>
        <source>The least angle between the surface and the direction its half leaves in.</source>
        <translation>表面与其半模离开方向之间的最小角度。</translation>
    </message>
    <message>
        <source>Best for the plane</source>
        <translation>对平面最佳</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>沿法线</translation>
    </message>
    <message>
        <source>As they are</source>
        <translation>保持现状</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>How the removal directions are chosen.</source>
        <translation>脱模方向如何选择。</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>倾斜上限</translation>
    </message>
    <message>
        <source>How far a direction may lean from the plane&apos;s normal.</source>
        <translation>方向最多可偏离平面法线多少。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>The axis that the press pulls along: both directions keep to it.</source>
        <translation>压机拉动的轴：两个方向都遵守它。</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>That of direction 1</source>
        <translation>方向 1 的轴</translation>
    </message>
    <message>
        <source>Off the axis</source>
        <translation>偏离轴</translation>
    </message>
    <message>
        <source>How far a direction may lean from the axis; 0 holds it there.</source>
        <translation>方向最多可偏离该轴多少；0 表示不偏离。</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Longest side</source>
        <translation>最长边</translation>
    </message>
    <message>
        <source>Scales the whole part.</source>
        <translation>缩放整个零件。</translation>
    </message>
    <message>
        <source>Place of its middle</source>
        <translation>中心的位置</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>尺寸，mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面数</translation>
    </message>
    <message>
        <source>%1 below %2</source>
        <translation>%1 低于 %2</translation>
    </message>
    <message>
        <source>Worst %1</source>
        <translation>最小 %1</translation>
    </message>
    <message>
        <source>Directions tilted by %1 and %2, %3 of the volume on the smaller side</source>
        <translation>方向倾斜 %1 和 %2，较小一侧占体积的 %3</translation>
    </message>
    <message>
        <source>Planes found, best first</source>
        <translation>找到的平面，最好的在前</translation>
    </message>
    <message>
        <source>Parting plane</source>
        <translation>分型面</translation>
    </message>
    <message>
        <source>Drag its grips in the view, or type here.</source>
        <translation>在视图中拖动把手，或在此输入。</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Distance of the plane from the origin along its normal.</source>
        <translation>平面沿其法线到原点的距离。</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>最小拔模角</translation>
    </message>
    <message>
        <source>Area below</source>
        <translation>低于的面积</translation>
    </message>
    <message>
        <source>Direction 1</source>
        <translation>方向 1</translation>
    </message>
    <message>
        <source>Angle to the plane&apos;s normal.</source>
        <translation>与平面法线的角度。</translation>
    </message>
    <message>
        <source>Direction 2</source>
        <translation>方向 2</translation>
    </message>
    <message>
        <source>Sharpest crease</source>
        <translation>最锐的折痕</translation>
    </message>
    <message>
        <source>At the parting line, where the directions are not parallel.</source>
        <translation>在分型线处，两个方向不平行时产生。</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>方向 %1</translation>
    </message>
    <message>
        <source>Drag the arrow&apos;s tip in the view, or type here.</source>
        <translation>在视图中拖动箭头尖，或在此输入。</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Leans towards</source>
        <translation>倾向</translation>
    </message>
    <message>
        <source>The way it leans, counted in the plane. Without tilt it says nothing.</source>
        <translation>倾斜的朝向，在平面内计。没有倾斜时无意义。</translation>
    </message>
    <message>
        <source>X, Y, Z</source>
        <translation>X, Y, Z</translation>
    </message>
    <message>
        <source>While it runs</source>
        <translation>运行时</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>变形</translation>
    </message>
    <message>
        <source>Bends the part until both halves come off.</source>
        <translation>弯曲零件，直到两个半模都能脱开。</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>How the shape is bent.</source>
        <translation>形状如何弯曲。</translation>
    </message>
    <message>
        <source>Elastic, then finish</source>
        <translation>弹性，然后完成</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>按论文</translation>
    </message>
    <message>
        <source>Where bending fails</source>
        <translation>弯曲失败处</translation>
    </message>
    <message>
        <source>What becomes of places that no bending frees: told as an obstruction, or filled.</source>
        <translation>弯曲无法解开之处如何处理：报告为障碍，或填充。</translation>
    </message>
    <message>
        <source>Leave as it is</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>能量</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>平均距离</translation>
    </message>
    <message>
        <source>To the part, over its diagonal, after the best rigid fit.</source>
        <translation>到零件的距离除以其对角线，最佳刚性拟合后。</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X, Y, Z, mm</source>
        <translation>X, Y, Z, mm</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧</translation>
    </message>
    <message>
        <source>What helps</source>
        <translation>解决办法</translation>
    </message>
    <message>
        <source>Cast</source>
        <translation>铸件</translation>
    </message>
    <message>
        <source>What will come out of the mold.</source>
        <translation>将从模具中出来的东西。</translation>
    </message>
    <message>
        <source>Castability</source>
        <translation>可铸造性</translation>
    </message>
    <message>
        <source>Self-intersections</source>
        <translation>自相交</translation>
    </message>
    <message>
        <source>Parting curve</source>
        <translation>分型曲线</translation>
    </message>
    <message>
        <source>Proved</source>
        <translation>已证明</translation>
    </message>
    <message>
        <source>Kept from the part</source>
        <translation>与零件相比</translation>
    </message>
    <message>
        <source>Over the part&apos;s diagonal, after the best rigid fit.</source>
        <translation>除以零件对角线，最佳刚性拟合后。</translation>
    </message>
    <message>
        <source>Filled</source>
        <translation>已填充</translation>
    </message>
    <message>
        <source>What was filled in where no bending helps, over the part&apos;s volume.</source>
        <translation>在弯曲无用处填入的部分，占零件体积。</translation>
    </message>
    <message>
        <source>Shortest limb</source>
        <translation>最短的肢体</translation>
    </message>
    <message>
        <source>Length, cast over part.</source>
        <translation>长度，铸件比零件。</translation>
    </message>
    <message>
        <source>no limbs</source>
        <translation>没有肢体</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>found</source>
        <translation>有</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>简单</translation>
    </message>
    <message>
        <source>crosses itself</source>
        <translation>自相交</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Turn direction %1</source>
        <translation>转动方向 %1</translation>
    </message>
    <message>
        <source>Scale the part</source>
        <translation>缩放零件</translation>
    </message>
    <message>
        <source>Move the part</source>
        <translation>移动零件</translation>
    </message>
    <message>
        <source>Move the plane</source>
        <translation>移动平面</translation>
    </message>
    <message>
        <source>Change the deformation&apos;s settings</source>
        <translation>更改变形设置</translation>
    </message>
    <message>
        <source>While it bends</source>
        <translation>变形过程中</translation>
    </message>
    <message>
        <source>Whether directions that are best for the plane are sought anew as the shape bends. The paper&apos;s method always does that.</source>
        <translation>变形过程中是否重新寻找对分型面最佳的方向。论文方法总是如此。</translation>
    </message>
    <message>
        <source>They stay</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>They follow the shape</source>
        <translation>随形状更新</translation>
    </message>
    <message>
        <source>Smoothing γ</source>
        <translation>平滑 γ</translation>
    </message>
    <message>
        <source>How much neighbours turn alike in the paper&apos;s method.</source>
        <translation>论文方法中相邻部分一同转动的程度。</translation>
    </message>
    <message>
        <source>Change the mold</source>
        <translation>更改模具</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题栏</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Of the part.</source>
        <translation>零件的名称。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>As its drawing has it.</source>
        <translation>与图纸一致。</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Change the title</source>
        <translation>更改标题栏</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Goat head</source>
        <translation>山羊头</translation>
    </message>
    <message>
        <source>Curled horns, an eye worth keeping</source>
        <translation>弯曲的角，值得保留的眼睛</translation>
    </message>
    <message>
        <source>Sitting rabbit</source>
        <translation>坐兔</translation>
    </message>
    <message>
        <source>Ears that lean apart</source>
        <translation>分开的双耳</translation>
    </message>
    <message>
        <source>Standing goat</source>
        <translation>站立的山羊</translation>
    </message>
    <message>
        <source>Four legs, two horns, one plane</source>
        <translation>四条腿、两只角、一个平面</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Which plane suits the fingers?</source>
        <translation>哪个平面适合手指？</translation>
    </message>
    <message>
        <source>Fish</source>
        <translation>鱼</translation>
    </message>
    <message>
        <source>Keep the curve of the tail fin</source>
        <translation>保留尾鳍的曲线</translation>
    </message>
    <message>
        <source>Bent beam</source>
        <translation>弯梁</translation>
    </message>
    <message>
        <source>Sharp corners, exact flanges</source>
        <translation>锐利的棱角，精确的翼缘</translation>
    </message>
    <message>
        <source>Door knob</source>
        <translation>门把手</translation>
    </message>
    <message>
        <source>A neck that locks in any mold</source>
        <translation>在任何模具中都会卡住的颈部</translation>
    </message>
    <message>
        <source>Praline</source>
        <translation>夹心糖</translation>
    </message>
    <message>
        <source>Flat back, castable as it is</source>
        <translation>平背，本身即可铸造</translation>
    </message>
</context>
<context>
    <name>UndercutPages</name>
    <message>
        <source>Undercut %1</source>
        <translation>倒扣 %1</translation>
    </message>
    <message>
        <source>fill, %1</source>
        <translation>填充，%1</translation>
    </message>
    <message>
        <source>bend, %1</source>
        <translation>弯曲，%1</translation>
    </message>
    <message>
        <source>Undercuts</source>
        <translation>倒扣</translation>
    </message>
    <message>
        <source>What a half cannot leave at this plane, region by region.</source>
        <translation>在此平面半模无法离开的部分，逐区列出。</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Not to be bent</source>
        <translation>不可弯曲</translation>
    </message>
    <message>
        <source>Regions that no bending frees.</source>
        <translation>弯曲无法解开的区域。</translation>
    </message>
    <message>
        <source>To fill all</source>
        <translation>全部填充</translation>
    </message>
    <message>
        <source>No bending frees it: have it filled, or move the plane.</source>
        <translation>弯曲无法解开：请填充，或移动平面。</translation>
    </message>
    <message>
        <source>Bending frees it. Filled, what lies about it stays as it is.</source>
        <translation>弯曲可解开。填充则周围保持原样。</translation>
    </message>
    <message>
        <source>Filling it joins pieces of the part that are apart.</source>
        <translation>填充会把分开的块连在一起。</translation>
    </message>
    <message>
        <source>What becomes of it</source>
        <translation>如何处理</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>处理</translation>
    </message>
    <message>
        <source>By the rule: as the page of Deform says for all.</source>
        <translation>按规则：与“变形”页对全部的规定相同。</translation>
    </message>
    <message>
        <source>By the rule</source>
        <translation>按规则</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>弯曲</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X, Y, Z, mm</source>
        <translation>X, Y, Z, mm</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧</translation>
    </message>
    <message>
        <source>To fill</source>
        <translation>要填充</translation>
    </message>
    <message>
        <source>What filling it takes, over the part&apos;s volume.</source>
        <translation>填充所需，占零件体积。</translation>
    </message>
    <message>
        <source>both</source>
        <translation>两侧</translation>
    </message>
</context>
<context>
    <name>VariantPages</name>
    <message>
        <source>not run</source>
        <translation>未运行</translation>
    </message>
    <message>
        <source>not castable</source>
        <translation>不可铸造</translation>
    </message>
    <message>
        <source>Castable</source>
        <translation>可铸造</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>最小拔模角</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>Farthest, mm</source>
        <translation>最大偏差，mm</translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation>均方根，mm</translation>
    </message>
    <message>
        <source>Filled, cm³</source>
        <translation>填充，cm³</translation>
    </message>
    <message>
        <source>Block, mm</source>
        <translation>模块，mm</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步数</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>one</source>
        <translation>一个</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>变型</translation>
    </message>
    <message>
        <source>Several designs of this part in one project.</source>
        <translation>一个项目中同一零件的多个设计。</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>并排比较</translation>
    </message>
    <message>
        <source>Distances are to the part, after the best rigid fit; the bold one is the current one, which all other pages show.</source>
        <translation>距离是最佳刚性配准后到零件的距离；粗体的是当前变型，其他页面显示的都是它。</translation>
    </message>
    <message>
        <source>One design so far. Duplicate it to try another plane, other pins or weights, and to compare both.</source>
        <translation>目前只有一个设计。复制它即可尝试另一个分型面、其他固定点或权重，并比较两者。</translation>
    </message>
    <message>
        <source>current, %1</source>
        <translation>当前，%1</translation>
    </message>
</context>
<context>
    <name>design</name>
    <message>
        <source>Filling would join pieces of the part that are apart. Allow it, take them apart further, or give another plane.</source>
        <translation>填充会把零件分开的块连在一起。请允许它、把它们分得更开，或给出另一个平面。</translation>
    </message>
    <message>
        <source>The pins draw the part through itself at ({0}, {1}, {2}). Leave one of them out, or give another plane.</source>
        <translation>固定点使零件在 ({0}, {1}, {2}) 处穿过自身。请去掉其中一个，或给出另一个平面。</translation>
    </message>
    <message>
        <source>Undercuts were chosen to be filled or bent, and no plane was given: which undercuts there are depends on it. Give a plane too.</source>
        <translation>已选定要填充或弯曲的倒扣，但没有给出平面：有哪些倒扣取决于平面。请同时给出平面。</translation>
    </message>
    <message>
        <source>No direction within {0}° of the axis leaves the plane within {1}° of its normal. Turn the plane towards the axis, or allow more.</source>
        <translation>在轴的 {0}° 之内没有方向能以距法线 {1}° 之内离开平面。请把平面转向该轴，或放宽限制。</translation>
    </message>
    <message>
        <source>The design was cancelled.</source>
        <translation>设计已取消。</translation>
    </message>
    <message>
        <source>The undercut near {0} is to be bent, and no bending frees it. Have it filled, or move the plane.</source>
        <translation>{0} 附近的倒扣要弯曲，但弯曲无法解开它。请填充它，或移动平面。</translation>
    </message>
    <message>
        <source>A piece of {2} mm spans another piece on side {0}, near {1}: they hang in one another, and no half can leave between them. Take them apart, or have them merged.</source>
        <translation>一个 {2} mm 的块在第 {0} 侧 {1} 附近跨过另一个块：它们彼此相扣，没有半模能从中离开。请把它们分开，或合并。</translation>
    </message>
    <message>
        <source>A closed piece of {2} mm lies wholly on side {0}, near {1}: it never meets the parting plane. Move the plane through it.</source>
        <translation>一个 {2} mm 的封闭块完全在第 {0} 侧，{1} 附近：它不与分型面相交。请让平面穿过它。</translation>
    </message>
    <message>
        <source>A handle of {2} mm stands on side {0}, near {1}: the mold cannot leave its hole. Move the plane through the hole, or fill it.</source>
        <translation>一个 {2} mm 的把手在第 {0} 侧，{1} 附近：模具无法离开它的孔。请让平面穿过孔，或填充它。</translation>
    </message>
    <message>
        <source>An arch of {2} mm spans a gap on side {0}, near {1}: the mold under it cannot leave. Move the plane, or fill the gap.</source>
        <translation>一个 {2} mm 的拱在第 {0} 侧 {1} 附近跨过空隙：其下的模具无法离开。请移动平面，或填充空隙。</translation>
    </message>
    <message>
        <source>A pocket of air of {2} mm lies on side {0}, near {1}: the mold in it cannot leave. Move the plane, or fill the pocket.</source>
        <translation>一个 {2} mm 的气穴在第 {0} 侧，{1} 附近：其中的模具无法离开。请移动平面，或填充气穴。</translation>
    </message>
    <message>
        <source>The parting line could not be inserted without the surface crossing itself.</source>
        <translation>无法插入分型线而不使表面自相交。</translation>
    </message>
    <message>
        <source>A pinned point of the surface could not be made a point of the parting line. Pin a point inside the part instead.</source>
        <translation>表面上的一个固定点无法成为分型线的点。请改为固定零件内部的点。</translation>
    </message>
    <message>
        <source>Move the plane by {0} mm towards side {1}: nothing is in the way there.</source>
        <translation>把平面向第 {1} 侧移动 {0} mm：那里没有阻碍。</translation>
    </message>
    <message>
        <source>Part it square to ({0}, {1}, {2}), {3} mm from the origin, instead: nothing is in the way there.</source>
        <translation>改为垂直于 ({0}, {1}, {2})、距原点 {3} mm 处分型：那里没有阻碍。</translation>
    </message>
    <message>
        <source>Have it joined to the piece beside it: that fills in {0} cm³, {1} % of the part.</source>
        <translation>让它与旁边的块相连：填入 {0} cm³，占零件的 {1} %。</translation>
    </message>
    <message>
        <source>Fill it: that takes {0} cm³, {1} % of the part.</source>
        <translation>填充它：需要 {0} cm³，占零件的 {1} %。</translation>
    </message>
    <message>
        <source>Pin the point {0} to the plane, {1} mm away, so that the plane runs through it.</source>
        <translation>把 {1} mm 外的点 {0} 固定到平面，使平面通过它。</translation>
    </message>
    <message>
        <source>The shape that the run had reached could not be parted at this plane: bending began anew with the part.</source>
        <translation>运行已达到的形状无法在此平面分型：已从零件重新开始变形。</translation>
    </message>
</context>
<context>
    <name>exchange</name>
    <message>
        <source>The folder {0} could not be made: {1}.</source>
        <translation>无法创建文件夹 {0}：{1}。</translation>
    </message>
    <message>
        <source>{0} could not be written: {1}.</source>
        <translation>无法写入 {0}：{1}。</translation>
    </message>
    <message>
        <source>There is no file {0}.</source>
        <translation>没有文件 {0}。</translation>
    </message>
    <message>
        <source>{0} is a folder, not a mesh file.</source>
        <translation>{0} 是文件夹，不是网格文件。</translation>
    </message>
    <message>
        <source>{0} is not a plain file.</source>
        <translation>{0} 不是普通文件。</translation>
    </message>
    <message>
        <source>{0} could not be read: {1}.</source>
        <translation>无法读取 {0}：{1}。</translation>
    </message>
    <message>
        <source>The worker program&apos;s answer is incomplete.</source>
        <translation>工作程序的回答不完整。</translation>
    </message>
    <message>
        <source>{0} is an empty file.</source>
        <translation>{0} 是空文件。</translation>
    </message>
    <message>
        <source>{0} is in no format that Moldwright reads: STL, OBJ, PLY or OFF.</source>
        <translation>{0} 不是 Moldwright 能读取的格式：STL、OBJ、PLY 或 OFF。</translation>
    </message>
    <message>
        <source>{0}, line {1}: “{2}” is not understood in the header of a PLY file of version 1.0.</source>
        <translation>{0}，第 {1} 行：在 1.0 版 PLY 文件头中不能理解“{2}”。</translation>
    </message>
    <message>
        <source>{0} ends within its header: the line “end_header” is missing.</source>
        <translation>{0} 在文件头中结束：缺少“end_header”行。</translation>
    </message>
    <message>
        <source>{0}, {1}: a face&apos;s corner is “{2}”, not the number of a point from 1 on.</source>
        <translation>{0}，{1}：面的角是“{2}”，而不是从 1 起的点编号。</translation>
    </message>
    <message>
        <source>{0} is not an OBJ file: it holds binary data.</source>
        <translation>{0} 不是 OBJ 文件：它含二进制数据。</translation>
    </message>
    <message>
        <source>{0} ends too early: after {1} of {2} points and {3} of {4} faces.</source>
        <translation>{0} 结束得太早：{2} 个点中有 {1} 个，{4} 个面中有 {3} 个。</translation>
    </message>
    <message>
        <source>{0} holds points of other than three dimensions.</source>
        <translation>{0} 含有非三维的点。</translation>
    </message>
    <message>
        <source>{0} is a binary OFF file; only OFF in text is read.</source>
        <translation>{0} 是二进制 OFF 文件；只读取文本 OFF。</translation>
    </message>
    <message>
        <source>{0}, {1}: here should stand how many points and faces there are, not “{2}”.</source>
        <translation>{0}，{1}：这里应写明点数和面数，而不是“{2}”。</translation>
    </message>
    <message>
        <source>{0}, {1}: a face of {2} corners needs as many numbers of points. The file may be cut off.</source>
        <translation>{0}，{1}：有 {2} 个角的面需要同样多的点编号。文件可能被截断。</translation>
    </message>
    <message>
        <source>What follows the last face was ignored.</source>
        <translation>最后一个面之后的内容已忽略。</translation>
    </message>
    <message>
        <source>{0} spare bytes at the end were ignored.</source>
        <translation>末尾多余的 {0} 个字节已忽略。</translation>
    </message>
    <message>
        <source>{0} holds its surface as tristrips (strips of triangles). Save it with plain faces.</source>
        <translation>{0} 以三角带保存表面。请以普通面保存。</translation>
    </message>
    <message>
        <source>{0} announces {1} times “{2}” but is too short to hold them.</source>
        <translation>{0} 声明有 {1} 个“{2}”，但太短容不下。</translation>
    </message>
    <message>
        <source>{0}, {1}: a number is missing here, not finite, or not a number. The file may be cut off.</source>
        <translation>{0}，{1}：这里缺少数字，或不是有限的数。文件可能被截断。</translation>
    </message>
    <message>
        <source>{0} is not a PLY file: it does not begin with “ply”.</source>
        <translation>{0} 不是 PLY 文件：它不以“ply”开头。</translation>
    </message>
    <message>
        <source>{0} announces {1} triangles but holds {2}. It is damaged, or not an STL file.</source>
        <translation>{0} 声明 {1} 个三角形，却含有 {2} 个。它已损坏，或不是 STL 文件。</translation>
    </message>
    <message>
        <source>{0}, {1}: a facet ends too early. The file may be cut off.</source>
        <translation>{0}，{1}：一个面片结束得太早。文件可能被截断。</translation>
    </message>
    <message>
        <source>{0} is not an STL file: it is text that does not begin with “solid”.</source>
        <translation>{0} 不是 STL 文件：它是不以“solid”开头的文本。</translation>
    </message>
    <message>
        <source>{0} is {1} bytes long, too short for an STL file.</source>
        <translation>{0} 只有 {1} 字节，作为 STL 文件太短。</translation>
    </message>
    <message>
        <source>{0}, {1}: a point needs three numbers, but the line ends early.</source>
        <translation>{0}，{1}：点需要三个数字，但该行结束得太早。</translation>
    </message>
    <message>
        <source>{0}, {1}: a point needs three finite numbers, but here stands “{2}”.</source>
        <translation>{0}，{1}：点需要三个有限的数字，但这里是“{2}”。</translation>
    </message>
    <message>
        <source>{0}, {1}: a coordinate is not a finite number.</source>
        <translation>{0}，{1}：坐标不是有限的数。</translation>
    </message>
    <message>
        <source>{0}, {1}: a face uses point {2}, which does not exist.</source>
        <translation>{0}，{1}：一个面用到不存在的点 {2}。</translation>
    </message>
    <message>
        <source>{0}, {1}: a face has {2} corners; 3 to {3} are possible.</source>
        <translation>{0}，{1}：一个面有 {2} 个角；只能有 3 到 {3} 个。</translation>
    </message>
    <message>
        <source>{0} holds no triangles.</source>
        <translation>{0} 不含三角形。</translation>
    </message>
    <message>
        <source>{0} holds {1} points but no faces.</source>
        <translation>{0} 含 {1} 个点，但没有面。</translation>
    </message>
    <message>
        <source>{0}, {1}: a face uses point {2}, counted from 0, but there are only {3}.</source>
        <translation>{0}，{1}：一个面用到从 0 数起的点 {2}，但只有 {3} 个点。</translation>
    </message>
    <message>
        <source>TetGen found no inside to fill.</source>
        <translation>TetGen 没有找到可填充的内部。</translation>
    </message>
    <message>
        <source>TetGen&apos;s answer does not keep the points of the surface.</source>
        <translation>TetGen 的回答没有保留表面的点。</translation>
    </message>
    <message>
        <source>TetGen left out a point inside the surface.</source>
        <translation>TetGen 漏掉了表面内的一个点。</translation>
    </message>
    <message>
        <source>TetGen&apos;s answer holds a flat tetrahedron.</source>
        <translation>TetGen 的回答含有扁平的四面体。</translation>
    </message>
    <message>
        <source>TetGen&apos;s answer fills {0} of the surface&apos;s volume of {1}.</source>
        <translation>TetGen 的回答只填充了表面体积 {1} 中的 {0}。</translation>
    </message>
    <message>
        <source>TetGen split {0} of the {1} faces of the surface.</source>
        <translation>TetGen 分割了表面 {1} 个面中的 {0} 个。</translation>
    </message>
    <message>
        <source>Stopped before the end.</source>
        <translation>在结束前停止。</translation>
    </message>
    <message>
        <source>The worker program was stopped after {0} seconds. A smaller mesh needs less time.</source>
        <translation>工作程序在 {0} 秒后被停止。较小的网格需要的时间更少。</translation>
    </message>
    <message>
        <source>The worker program&apos;s answer is larger than its limit of {0} MB.</source>
        <translation>工作程序的回答超过了 {0} MB 的限制。</translation>
    </message>
    <message>
        <source>The worker program was killed. The computer may be out of memory.</source>
        <translation>工作程序被终止。计算机可能内存不足。</translation>
    </message>
    <message>
        <source>The worker program crashed on this mesh (signal {0}).</source>
        <translation>工作程序在此网格上崩溃（信号 {0}）。</translation>
    </message>
    <message>
        <source>The worker program ended without an answer (code {0}).</source>
        <translation>工作程序没有回答就结束了（代码 {0}）。</translation>
    </message>
    <message>
        <source>The worker program {0} could not be started: {1}.</source>
        <translation>无法启动工作程序 {0}：{1}。</translation>
    </message>
    <message>
        <source>The worker program was asked for nothing.</source>
        <translation>辅助程序没有收到任务。</translation>
    </message>
    <message>
        <source>TetGen gave up on this surface (code {0}).</source>
        <translation>TetGen 放弃了此表面（代码 {0}）。</translation>
    </message>
    <message>
        <source>The worker program reached its memory limit on this mesh.</source>
        <translation>辅助程序处理此网格时达到了内存上限。</translation>
    </message>
    <message>
        <source>CGAL gave up on this surface.</source>
        <translation>CGAL 放弃了此表面。</translation>
    </message>
    <message>
        <source>{0} faces were removed: repeated, without area, or loose scraps.</source>
        <translation>删除了 {0} 个面：重复的、没有面积的或零散的碎片。</translation>
    </message>
    <message>
        <source>{0} holes were filled with {1} faces; the largest is {2} wide.</source>
        <translation>用 {1} 个面填补了 {0} 个孔；最大的宽 {2}。</translation>
    </message>
    <message>
        <source>The surface was made anew about {0} places where faces crossed each other.</source>
        <translation>在面相互交叉的 {0} 处周围重新生成了表面。</translation>
    </message>
    <message>
        <source>{0} cannot be mended: too much of its surface would be lost.</source>
        <translation>无法修补 {0}：会丢失过多的表面。</translation>
    </message>
    <message>
        <source>{0} cannot be repaired: its surface encloses nothing.</source>
        <translation>无法修复 {0}：其表面没有围住任何体积。</translation>
    </message>
    <message>
        <source>The faults were too many to mend: a closed skin was made about the surface, no farther than {0} from it. Gaps narrower than {1} are bridged, sharp edges rounded.</source>
        <translation>缺陷过多，无法逐个修补：在表面外生成了一层封闭的外皮，距表面不超过 {0}。窄于 {1} 的缝隙被桥接，锐边被倒圆。</translation>
    </message>
    <message>
        <source>{0} closed surfaces inside others were removed: they are solid now.</source>
        <translation>删除了 {0} 个位于其他表面内的封闭表面：该处现为实心。</translation>
    </message>
</context>
<context>
    <name>fill</name>
    <message>
        <source>Filling was cancelled.</source>
        <translation>填充已取消。</translation>
    </message>
    <message>
        <source>The undercuts could not be filled without the surface crossing itself. Move the parting plane a little.</source>
        <translation>无法填充倒扣而不使表面自相交。请稍微移动分型面。</translation>
    </message>
    <message>
        <source>These regions cannot be filled alone: the surface would cross itself. Fill the regions beside them too.</source>
        <translation>这些区域不能单独填充：表面会自相交。请也填充旁边的区域。</translation>
    </message>
</context>
<context>
    <name>mesh</name>
    <message>
        <source>{0} equal points were welded.</source>
        <translation>已焊接 {0} 个相同的点。</translation>
    </message>
    <message>
        <source>{0} faces that used a point twice were removed.</source>
        <translation>已移除 {0} 个两次使用同一点的面。</translation>
    </message>
    <message>
        <source>{0} repeated faces were removed.</source>
        <translation>已移除 {0} 个重复的面。</translation>
    </message>
    <message>
        <source>{0} points within a millionth of the size of each other were welded.</source>
        <translation>已焊接相距不到尺寸百万分之一的 {0} 个点。</translation>
    </message>
    <message>
        <source>The surface was inside out and was turned.</source>
        <translation>表面内外颠倒，已翻转。</translation>
    </message>
    <message>
        <source>{0} faces looked inward and were turned.</source>
        <translation>{0} 个面朝内，已翻转。</translation>
    </message>
    <message>
        <source>{0} holds no faces.</source>
        <translation>{0} 不含面。</translation>
    </message>
    <message>
        <source>{0} holds a coordinate that is not a finite number.</source>
        <translation>{0} 含有非有限数的坐标。</translation>
    </message>
    <message>
        <source>{0} measures {1} from corner to corner. No unit of length makes a part of that.</source>
        <translation>{0} 的对角尺寸为 {1}。没有任何长度单位能使其成为零件。</translation>
    </message>
    <message>
        <source>{0} of the {1} faces of {2} shrink to a line or a point. Its numbers have too few digits for its size or its place: write it with more digits, or nearer to the origin.</source>
        <translation>{2} 的 {1} 个面中有 {0} 个缩成线或点。相对于其大小或位置，数字的位数太少：请以更多位数写出，或更靠近原点。</translation>
    </message>
    <message>
        <source>{0} consists of {1} separate solids.</source>
        <translation>{0} 由 {1} 个分开的实体组成。</translation>
    </message>
    <message>
        <source>{0} encloses no volume, so there is nothing to cast.</source>
        <translation>{0} 不包围任何体积，因此没有可铸造的东西。</translation>
    </message>
    <message>
        <source>The surface of {0} has a hole, near {2}, so it has no inside to cast. Close it in the program that made the file.</source>
        <translation>{0} 的表面在 {2} 附近有一个孔，因此没有可铸造的内部。请在制作该文件的程序中封闭它。</translation>
    </message>
    <message>
        <source>The surface of {0} has {1} holes, one near {2}, so it has no inside to cast. Close them in the program that made the file.</source>
        <translation>{0} 的表面有 {1} 个孔，其一在 {2} 附近，因此没有可铸造的内部。请在制作该文件的程序中封闭它们。</translation>
    </message>
    <message>
        <source>In {0} more than two faces meet at an edge: {1} faces are concerned, one near {2}. Separate the parts, or join them, in the program that made the file.</source>
        <translation>{0} 中有多于两个面在一条边相交：涉及 {1} 个面，其一在 {2} 附近。请在制作该文件的程序中把各部分分开或连接。</translation>
    </message>
    <message>
        <source>The surface of {0} touches itself in a single point, at {2}. Separate it there in the program that made the file.</source>
        <translation>{0} 的表面在 {2} 处单点接触自身。请在制作该文件的程序中分开。</translation>
    </message>
    <message>
        <source>The surface of {0} touches itself in {1} single points, one at {2}. Separate it there in the program that made the file.</source>
        <translation>{0} 的表面在 {1} 个单点接触自身，其一在 {2}。请在制作该文件的程序中分开。</translation>
    </message>
    <message>
        <source>A face of {0} has no area, near {2}. Clean the mesh in the program that made the file.</source>
        <translation>{0} 的一个面没有面积，在 {2} 附近。请在制作该文件的程序中清理网格。</translation>
    </message>
    <message>
        <source>{1} faces of {0} have no area, one near {2}. Clean the mesh in the program that made the file.</source>
        <translation>{0} 的 {1} 个面没有面积，其一在 {2} 附近。请在制作该文件的程序中清理网格。</translation>
    </message>
    <message>
        <source>{0} crosses itself in one place, near {2}. A proof needs a surface that does not.</source>
        <translation>{0} 在一处与自身相交，{2} 附近。证明需要不自相交的表面。</translation>
    </message>
    <message>
        <source>{0} crosses itself in {1} places, one near {2}. A proof needs a surface that does not.</source>
        <translation>{0} 在 {1} 处与自身相交，其一在 {2} 附近。证明需要不自相交的表面。</translation>
    </message>
    <message>
        <source>{0} holds a closed surface inside another, near {2}. A closed cavity cannot be cast in a two-piece mold. Remove it, or open it to the outside.</source>
        <translation>{0} 在 {2} 附近含有一个位于另一表面内的封闭表面。两片模无法铸造封闭的空腔。请移除它，或使其与外部相通。</translation>
    </message>
    <message>
        <source>{0} holds {1} closed surfaces inside others, one near {2}. A closed cavity cannot be cast in a two-piece mold. Remove them, or open them to the outside.</source>
        <translation>{0} 含有 {1} 个位于其他表面内的封闭表面，其一在 {2} 附近。两片模无法铸造封闭的空腔。请移除它们，或使其与外部相通。</translation>
    </message>
    <message>
        <source>The surface of {0} has only one side: its faces cannot all look outward, as near {1}. It has no inside to cast.</source>
        <translation>{0} 的表面只有一面：它的面不能全部朝外，例如在 {1} 附近。它没有可铸造的内部。</translation>
    </message>
</context>
<context>
    <name>moldwright::Banner</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>moldwright::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>查找命令</translation>
    </message>
</context>
<context>
    <name>moldwright::Dock</name>
    <message>
        <source>Float or dock %1</source>
        <translation>浮动或停靠 %1</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>关闭 %1</translation>
    </message>
</context>
<context>
    <name>moldwright::FigureTable</name>
    <message>
        <source>%1, the current one</source>
        <translation>%1，当前变型</translation>
    </message>
</context>
<context>
    <name>moldwright::FrameSlider</name>
    <message>
        <source>Frames of the run</source>
        <translation>运行的各帧</translation>
    </message>
    <message>
        <source>Goes back through the run; &quot;Go on from here&quot; begins another run from the frame in view.</source>
        <translation>在运行过程中回看；“从此处继续”从所示帧开始新的运行。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
</context>
<context>
    <name>moldwright::ImportDialog</name>
    <message>
        <source>Size of %1</source>
        <translation>%1 的尺寸</translation>
    </message>
    <message>
        <source>This part is %1 units long. What is one unit?</source>
        <translation>此零件长 %1 个单位。一个单位是多少？</translation>
    </message>
    <message>
        <source>Millimetre</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Centimetre</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>Metre</source>
        <translation>米</translation>
    </message>
    <message>
        <source>Inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>其他尺寸</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>单位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Longest side</source>
        <translation>最长边(&amp;L)</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Open the part</source>
        <translation>打开零件</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>moldwright::KeySheet</name>
    <message>
        <source>Orbit about the point under the pointer</source>
        <translation>绕指针下的点旋转</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Zoom to the pointer</source>
        <translation>缩放到指针处</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>Mouse: %1</source>
        <translation>鼠标：%1</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>left button</source>
        <translation>左键</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>中键</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>右键</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>按键与鼠标</translation>
    </message>
</context>
<context>
    <name>moldwright::KeyTable</name>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>命令及其按键</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>Type other keys</source>
        <translation>按下其他按键</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>重置所有按键</translation>
    </message>
    <message>
        <source>%1 belongs to %2. Give that command other keys first.</source>
        <translation>%1 属于 %2。请先给那个命令其他按键。</translation>
    </message>
</context>
<context>
    <name>moldwright::MainWindow</name>
    <message>
        <source>Opened</source>
        <translation>已打开</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>继续(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Moldwright</source>
        <translation>Moldwright</translation>
    </message>
    <message>
        <source>%1 (changed) · Moldwright</source>
        <translation>%1（已更改）· Moldwright</translation>
    </message>
    <message>
        <source>%1 · Moldwright</source>
        <translation>%1 · Moldwright</translation>
    </message>
    <message>
        <source>&lt;b&gt;?&lt;/b&gt; shows all keys.</source>
        <translation>&lt;b&gt;?&lt;/b&gt; 显示所有按键。</translation>
    </message>
    <message>
        <source>Open a part, drop one here, or choose a sample. %1</source>
        <translation>打开零件、把零件拖到这里，或选择示例。%1</translation>
    </message>
    <message>
        <source>The shape rests. &lt;b&gt;Space&lt;/b&gt; bends it further, &lt;b&gt;Ctrl+Shift+Return&lt;/b&gt; finishes it.</source>
        <translation>形状静止。&lt;b&gt;空格&lt;/b&gt;继续弯曲，&lt;b&gt;Ctrl+Shift+Return&lt;/b&gt; 完成它。</translation>
    </message>
    <message>
        <source>&lt;b&gt;X&lt;/b&gt; opens and closes the mold. %1</source>
        <translation>&lt;b&gt;X&lt;/b&gt; 打开和合上模具。%1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt; a grip of the plane or the tip of an arrow, with &lt;b&gt;Ctrl&lt;/b&gt; in whole steps. %1</source>
        <translation>&lt;b&gt;拖动&lt;/b&gt;平面的把手或箭头尖，按住 &lt;b&gt;Ctrl&lt;/b&gt; 则按整步。%1</translation>
    </message>
    <message>
        <source>Directions along the normal</source>
        <translation>方向沿法线</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>About Moldwright</source>
        <translation>关于 Moldwright</translation>
    </message>
    <message>
        <source>Takes any closed mesh to a castable shape and a proved two-piece mold, after Stein et al. 2019. Free software under the GNU AGPL 3 or later. Built on Qt, VTK, CGAL, OpenMesh, Eigen, TetGen and oneTBB.</source>
        <translation>把任何封闭网格变成可铸造的形状和经证明的两片模，依据 Stein 等人 2019。自由软件，GNU AGPL 3 或更高版本。基于 Qt、VTK、CGAL、OpenMesh、Eigen、TetGen 和 oneTBB。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 有未保存的更改。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Close without saving</source>
        <translation>不保存就关闭</translation>
    </message>
    <message>
        <source>Keep it open</source>
        <translation>保持打开</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Moldwright projects (*.moldwright)</source>
        <translation>Moldwright 项目 (*.moldwright)</translation>
    </message>
    <message>
        <source>Open a part</source>
        <translation>打开零件</translation>
    </message>
    <message>
        <source>Parts and projects (*.stl *.obj *.ply *.off *.moldwright);;All files (*)</source>
        <translation>零件和项目 (*.stl *.obj *.ply *.off *.moldwright);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Export the shape</source>
        <translation>导出形状</translation>
    </message>
    <message>
        <source>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;OFF (*.off)</source>
        <translation>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;OFF (*.off)</translation>
    </message>
    <message>
        <source>Folder for the halves</source>
        <translation>半模的文件夹</translation>
    </message>
    <message>
        <source>Print the report</source>
        <translation>打印报告</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Pins from a file</source>
        <translation>从文件读固定点</translation>
    </message>
    <message>
        <source>Pins (*.json);;All files (*)</source>
        <translation>固定点 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Pins into a file</source>
        <translation>固定点写入文件</translation>
    </message>
    <message>
        <source>Pins (*.json)</source>
        <translation>固定点 (*.json)</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be written to %1.</source>
        <translation>无法把图片写入 %1。</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>保存旋转动画</translation>
    </message>
    <message>
        <source>Animated PNG (*.png)</source>
        <translation>动态 PNG (*.png)</translation>
    </message>
    <message>
        <source>Picture %1 of %2 around the part. &lt;b&gt;Esc&lt;/b&gt; stops.</source>
        <translation>绕零件的第 %1 张图片，共 %2 张。&lt;b&gt;Esc&lt;/b&gt; 停止。</translation>
    </message>
    <message>
        <source>Turntable written to %1.</source>
        <translation>旋转动画已写入 %1。</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>Mouse &amp;navigation</source>
        <translation>鼠标导航(&amp;N)</translation>
    </message>
    <message>
        <source>Like the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>Navigation: %1</source>
        <translation>导航：%1</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>引导</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>变形</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>模具</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Every edit appears here. Click one to go back to it.</source>
        <translation>每次编辑都出现在这里。点击一项即可回到那里。</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a place, a second for the distance, a third for the angle. &lt;b&gt;Ctrl+C&lt;/b&gt; copies, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;点击&lt;/b&gt;一个位置，再点一个得距离，第三个得角度。&lt;b&gt;Ctrl+C&lt;/b&gt; 复制，&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; the face that shall lie on the ground. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;点击&lt;/b&gt;要放在地面上的面。&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a point of the surface to pin it, with &lt;b&gt;Shift&lt;/b&gt; the point inside below it. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;点击&lt;/b&gt;表面的点以固定它，按住 &lt;b&gt;Shift&lt;/b&gt; 则固定其下方内部的点。&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; to pin the point inside below the pointer, with &lt;b&gt;Shift&lt;/b&gt; the one on the surface. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;点击&lt;/b&gt;以固定指针下方内部的点，按住 &lt;b&gt;Shift&lt;/b&gt; 则固定表面上的点。&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; the face that the parting plane shall lie in. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;点击&lt;/b&gt;分型面要所在的面。&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; point %1 of 3 that the parting plane shall run through. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;点击&lt;/b&gt;分型面要通过的第 %1 个点，共 3 个。&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>These points lie on a line, so they give no plane. Click three others.</source>
        <translation>这些点在一条直线上，不能确定平面。请点击另外三个点。</translation>
    </message>
    <message>
        <source>Snap the plane</source>
        <translation>吸附平面</translation>
    </message>
    <message>
        <source>Click the sitting rabbit. A part of your own opens with %1.</source>
        <translation>点击坐兔。用 %1 打开您自己的零件。</translation>
    </message>
    <message>
        <source>Choose where the mold parts</source>
        <translation>选择模具在哪里分开</translation>
    </message>
    <message>
        <source>%1 searches the best planes. Try the pictures at the right: red is what would lock in the mold, and less of it is to be bent.</source>
        <translation>%1 搜索最佳平面。试试右侧的图片：红色是会卡在模具里的部分，越少则要弯曲的越少。</translation>
    </message>
    <message>
        <source>Bend it until it comes out</source>
        <translation>弯曲到能脱模为止</translation>
    </message>
    <message>
        <source>%1 runs. The part bends before your eyes until nothing is red, and the result is proved. What you want to hold on the plane, pin it first, under Guides.</source>
        <translation>%1 运行。零件在您眼前弯曲，直到不再有红色，结果得到证明。要留在平面上的部分，请先在“引导”中固定。</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>看一看</translation>
    </message>
    <message>
        <source>Turn it with %1 held. %2 paints how far cast and part are apart, %3 how steep each face is. If an ear went wrong, take another plane and run again.</source>
        <translation>%1拖动以旋转。%2 显示铸件与零件相距多远，%3 显示各面有多陡。若耳朵弯错了，请换一个平面再运行。</translation>
    </message>
    <message>
        <source>Shift and the middle button</source>
        <translation>按住 Shift 和中键</translation>
    </message>
    <message>
        <source>Make the mold</source>
        <translation>制作模具</translation>
    </message>
    <message>
        <source>%1 builds both halves and proves that they open. %2 moves them apart; %3 writes them to files.</source>
        <translation>%1 构建两个半模并证明能打开。%2 把它们分开；%3 把它们写入文件。</translation>
    </message>
    <message>
        <source>Turn direction 1</source>
        <translation>转动方向 1</translation>
    </message>
    <message>
        <source>Turn direction 2</source>
        <translation>转动方向 2</translation>
    </message>
    <message>
        <source>Move the plane</source>
        <translation>移动平面</translation>
    </message>
    <message>
        <source>%1 to plane normal</source>
        <translation>与平面法线成 %1</translation>
    </message>
    <message>
        <source>Crease up to %1</source>
        <translation>折痕最大 %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;B&lt;/b&gt; takes the brush; &lt;b&gt;F2&lt;/b&gt; renames the region, &lt;b&gt;Del&lt;/b&gt; removes it. %1</source>
        <translation>&lt;b&gt;B&lt;/b&gt; 取画笔；&lt;b&gt;F2&lt;/b&gt; 重命名区域，&lt;b&gt;Del&lt;/b&gt; 移除它。%1</translation>
    </message>
    <message>
        <source>Regions from a file</source>
        <translation>从文件读区域</translation>
    </message>
    <message>
        <source>Regions (*.json);;All files (*)</source>
        <translation>区域 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Regions into a file</source>
        <translation>区域写入文件</translation>
    </message>
    <message>
        <source>Regions (*.json)</source>
        <translation>区域 (*.json)</translation>
    </message>
    <message>
        <source>a new region</source>
        <translation>新区域</translation>
    </message>
    <message>
        <source>Strokes halve the weight.</source>
        <translation>笔画使权重减半。</translation>
    </message>
    <message>
        <source>Strokes double the weight in %1.</source>
        <translation>笔画使 %1 的权重加倍。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw&lt;/b&gt; around the faces. %1 With &lt;b&gt;Ctrl&lt;/b&gt; the opposite, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;圈出&lt;/b&gt;各面。%1 按住 &lt;b&gt;Ctrl&lt;/b&gt; 则相反，&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a face. %1 With &lt;b&gt;Ctrl&lt;/b&gt; the opposite, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;点击&lt;/b&gt;一个面。%1 按住 &lt;b&gt;Ctrl&lt;/b&gt; 则相反，&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw&lt;/b&gt; over the part. %1 With &lt;b&gt;Ctrl&lt;/b&gt; the opposite, &lt;b&gt;F&lt;/b&gt; or &lt;b&gt;Alt+wheel&lt;/b&gt; resizes, &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>在零件上&lt;b&gt;涂画&lt;/b&gt;。%1 按住 &lt;b&gt;Ctrl&lt;/b&gt; 则相反，&lt;b&gt;F&lt;/b&gt; 或 &lt;b&gt;Alt+滚轮&lt;/b&gt;改变大小，&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>The part bends; plane, pins and draft may change meanwhile. &lt;b&gt;Space&lt;/b&gt; holds it, &lt;b&gt;Ctrl+.&lt;/b&gt; stops it.</source>
        <translation>零件正在变形；其间可更改分型面、固定点和拔模角。&lt;b&gt;空格键&lt;/b&gt;暂停，&lt;b&gt;Ctrl+.&lt;/b&gt; 停止。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Return&lt;/b&gt; makes the chosen variant the current one, &lt;b&gt;Ctrl+D&lt;/b&gt; duplicates it, &lt;b&gt;F2&lt;/b&gt; renames it, &lt;b&gt;Del&lt;/b&gt; removes it. %1</source>
        <translation>&lt;b&gt;回车&lt;/b&gt;把选中的变型设为当前，&lt;b&gt;Ctrl+D&lt;/b&gt; 复制，&lt;b&gt;F2&lt;/b&gt; 重命名，&lt;b&gt;Del&lt;/b&gt; 移除。%1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt; a disc to place a feature of the mold, with &lt;b&gt;Shift&lt;/b&gt; without steps. %1</source>
        <translation>&lt;b&gt;拖动&lt;/b&gt;圆点以放置模具特征，按住 &lt;b&gt;Shift&lt;/b&gt; 则不按步。%1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw&lt;/b&gt; around the suggested points that shall be pinned. &lt;b&gt;Esc&lt;/b&gt; leaves.</source>
        <translation>&lt;b&gt;圈出&lt;/b&gt;要固定的建议点。&lt;b&gt;Esc&lt;/b&gt; 退出。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Not saved when Moldwright ended. Kept as it was at %1.</source>
        <translation>Moldwright 结束时未保存。已保留 %1 时的状态。</translation>
    </message>
    <message>
        <source>Work of %1</source>
        <translation>%1 的工作</translation>
    </message>
    <message>
        <source>Not saved when Moldwright ended, and what was kept cannot be read.</source>
        <translation>Moldwright 结束时未保存，保留的内容也无法读取。</translation>
    </message>
    <message>
        <source>Another part was not saved when Moldwright ended.</source>
        <translation>Moldwright 结束时另一个零件尚未保存。</translation>
    </message>
    <message>
        <source>%1 was kept as it was at %2.</source>
        <translation>%1 已按 %2 时的状态保留。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a pin to choose it, with &lt;b&gt;Ctrl&lt;/b&gt; several, or draw a box; &lt;b&gt;Del&lt;/b&gt; removes them; &lt;b&gt;P&lt;/b&gt; pins another point. %1</source>
        <translation>&lt;b&gt;单击&lt;/b&gt;选择固定点，按住 &lt;b&gt;Ctrl&lt;/b&gt; 可选多个，也可框选；&lt;b&gt;Del&lt;/b&gt; 删除；&lt;b&gt;P&lt;/b&gt; 再钉一点。%1</translation>
    </message>
    <message>
        <source>No suggested point is seen inside the lasso.</source>
        <translation>套索内没有可见的建议点。</translation>
    </message>
    <message>
        <source>&lt;b&gt;F3&lt;/b&gt; goes from place to place, &lt;b&gt;Ctrl+R&lt;/b&gt; repairs the mesh, &lt;b&gt;F5&lt;/b&gt; reads the file again, &lt;b&gt;Esc&lt;/b&gt; goes back to what was open. %1</source>
        <translation>&lt;b&gt;F3&lt;/b&gt; 逐处查看，&lt;b&gt;Ctrl+R&lt;/b&gt; 修复网格，&lt;b&gt;F5&lt;/b&gt; 重新读取文件，&lt;b&gt;Esc&lt;/b&gt; 返回之前打开的内容。%1</translation>
    </message>
    <message>
        <source>Half %1</source>
        <translation>半模 %1</translation>
    </message>
    <message>
        <source>opens along direction %1</source>
        <translation>沿方向 %1 打开</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>最薄壁厚</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Steel between features</source>
        <translation>特征之间的钢料</translation>
    </message>
    <message>
        <source>Add parts to the mold</source>
        <translation>向模具添加零件</translation>
    </message>
    <message>
        <source>Moldwright projects (*.moldwright);;All files (*)</source>
        <translation>Moldwright 项目 (*.moldwright);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>moldwright::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Nothing to report.</source>
        <translation>没有消息。</translation>
    </message>
</context>
<context>
    <name>moldwright::PartView</name>
    <message>
        <source>View of the part</source>
        <translation>零件视图</translation>
    </message>
</context>
<context>
    <name>moldwright::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Find a preference or a key</source>
        <translation>查找首选项或按键</translation>
    </message>
    <message>
        <source>No preference has these words.</source>
        <translation>没有含这些词的首选项。</translation>
    </message>
    <message>
        <source>Appearance and mouse</source>
        <translation>外观与鼠标</translation>
    </message>
    <message>
        <source>Like the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Mouse navigation</source>
        <translation>鼠标导航</translation>
    </message>
    <message>
        <source>New parts begin with</source>
        <translation>新零件的初始值</translation>
    </message>
    <message>
        <source>Draft required</source>
        <translation>要求的拔模角</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>倾斜上限</translation>
    </message>
    <message>
        <source>Wall of the mold</source>
        <translation>模具壁厚</translation>
    </message>
</context>
<context>
    <name>moldwright::ProgressPlots</name>
    <message>
        <source>Energy, worst draft and violating area over the steps</source>
        <translation>各步的能量、最小拔模角和违规面积</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>能量</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>最小拔模角</translation>
    </message>
    <message>
        <source>Area below %1°</source>
        <translation>低于 %1° 的面积</translation>
    </message>
    <message>
        <source>A run draws energy, worst draft and area here, step by step.</source>
        <translation>运行会在此逐步绘出能量、拔模角和面积。</translation>
    </message>
</context>
<context>
    <name>moldwright::ProjectModel</name>
    <message>
        <source>shown</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隐藏</translation>
    </message>
</context>
<context>
    <name>moldwright::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
</context>
<context>
    <name>moldwright::PropertyPanel</name>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
</context>
<context>
    <name>moldwright::SectionBar</name>
    <message>
        <source>Section</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>At the parting plane</source>
        <translation>在分型面处</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>垂直于 X</translation>
    </message>
    <message>
        <source>Across Y</source>
        <translation>垂直于 Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>垂直于 Z</translation>
    </message>
    <message>
        <source>Which way the section lies</source>
        <translation>剖面的朝向</translation>
    </message>
    <message>
        <source>How far along the section lies</source>
        <translation>剖面的位置</translation>
    </message>
    <message>
        <source>Keep the other side</source>
        <translation>保留另一侧</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>关闭剖面</translation>
    </message>
    <message>
        <source>Facing the view</source>
        <translation>正对视图</translation>
    </message>
</context>
<context>
    <name>moldwright::StartPage</name>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Or drop a file anywhere: STL, OBJ, PLY, OFF, Moldwright projects.</source>
        <translation>或把文件拖到任何地方：STL、OBJ、PLY、OFF、Moldwright 项目。</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>清除列表</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Closed parts that you would really cast. Each opens as a copy.</source>
        <translation>真正会铸造的封闭零件。每个都以副本打开。</translation>
    </message>
</context>
<context>
    <name>moldwright::StatusProgress</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>moldwright::Tour</name>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>结束导览</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
</context>
<context>
    <name>moldwright::TurnDialog</name>
    <message>
        <source>Turn the part</source>
        <translation>转动零件</translation>
    </message>
    <message>
        <source>X axis</source>
        <translation>X 轴</translation>
    </message>
    <message>
        <source>Y axis</source>
        <translation>Y 轴</translation>
    </message>
    <message>
        <source>Z axis</source>
        <translation>Z 轴</translation>
    </message>
    <message>
        <source>Normal of the parting plane</source>
        <translation>分型面的法线</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>绕(&amp;A)</translation>
    </message>
    <message>
        <source>A&amp;ngle</source>
        <translation>角度(&amp;N)</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>moldwright::ViewBar</name>
    <message>
        <source>Tools of the view</source>
        <translation>视图工具</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>What the faces show</source>
        <translation>面显示什么</translation>
    </message>
</context>
<context>
    <name>moldwright::ViewPane</name>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>What this view shows</source>
        <translation>此视图显示什么</translation>
    </message>
    <message>
        <source>Newest shape</source>
        <translation>最新形状</translation>
    </message>
    <message>
        <source>Part as opened</source>
        <translation>打开时的零件</translation>
    </message>
    <message>
        <source>What the faces of this view show</source>
        <translation>此视图的面显示什么</translation>
    </message>
    <message>
        <source>Free view</source>
        <translation>自由视图</translation>
    </message>
    <message>
        <source>Compared variant</source>
        <translation>被比较的变型</translation>
    </message>
</context>
<context>
    <name>moldwright::Workbench</name>
    <message>
        <source>Something inside Moldwright broke; your work is as it was.</source>
        <translation>Moldwright 内部出错；您的工作保持原样。</translation>
    </message>
    <message>
        <source>%1 was stopped.</source>
        <translation>%1已停止。</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>转动零件</translation>
    </message>
    <message>
        <source>Turn the part by %1°</source>
        <translation>把零件转动 %1°</translation>
    </message>
    <message>
        <source>Lay the part flat</source>
        <translation>放平零件</translation>
    </message>
    <message>
        <source>Move the part to the middle</source>
        <translation>把零件移到中间</translation>
    </message>
    <message>
        <source>Restore the original shape</source>
        <translation>恢复原始形状</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>The search for planes was stopped.</source>
        <translation>平面搜索已停止。</translation>
    </message>
    <message>
        <source>Searching planes</source>
        <translation>正在搜索平面</translation>
    </message>
    <message>
        <source>Best plane</source>
        <translation>最佳平面</translation>
    </message>
    <message>
        <source>Plane %1 of the search</source>
        <translation>搜索的第 %1 个平面</translation>
    </message>
    <message>
        <source>Plane %1 of %2 taken: %3 % of the surface below %4°.</source>
        <translation>已采用第 %1 个平面，共 %2 个：%3 % 的表面低于 %4°。</translation>
    </message>
    <message>
        <source>Suggested plane</source>
        <translation>建议的平面</translation>
    </message>
    <message>
        <source>Suggested plane taken: nothing is in the way of the mold there. Run bends the part.</source>
        <translation>已采用建议的平面：那里没有东西挡住模具。运行会弯曲零件。</translation>
    </message>
    <message>
        <source>No direction keeps to the axis and to the tilt limit at this plane. Turn the plane, or allow more.</source>
        <translation>在此平面没有方向符合轴和倾斜上限。请转动平面，或放宽限制。</translation>
    </message>
    <message>
        <source>Searching directions</source>
        <translation>正在搜索方向</translation>
    </message>
    <message>
        <source>Best directions</source>
        <translation>最佳方向</translation>
    </message>
    <message>
        <source>Deforming</source>
        <translation>变形</translation>
    </message>
    <message>
        <source>Fill where bending fails</source>
        <translation>填充弯曲失败处</translation>
    </message>
    <message>
        <source>Building the mold</source>
        <translation>构建模具</translation>
    </message>
    <message>
        <source>Mold built: both halves are proved to come off.</source>
        <translation>模具已构建：两个半模已证明能脱开。</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>%1 opened.</source>
        <translation>已打开 %1。</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>正在保存 %1</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>%1 opened: %2 × %3 × %4 mm, closed.</source>
        <translation>已打开 %1：%2 × %3 × %4 mm，封闭。</translation>
    </message>
    <message>
        <source>The shape was not written: the file&apos;s name must end in stl, ply, obj or off.</source>
        <translation>未写入形状：文件名必须以 stl、ply、obj 或 off 结尾。</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Shape written to %1.</source>
        <translation>形状已写入 %1。</translation>
    </message>
    <message>
        <source>Writing the halves</source>
        <translation>正在写入半模</translation>
    </message>
    <message>
        <source>Mold halves written to %1.</source>
        <translation>半模已写入 %1。</translation>
    </message>
    <message>
        <source>Pin a point</source>
        <translation>固定一个点</translation>
    </message>
    <message>
        <source>Remove all pins</source>
        <translation>移除所有固定点</translation>
    </message>
    <message>
        <source>Reading pins</source>
        <translation>读取固定点</translation>
    </message>
    <message>
        <source>Pins from a file</source>
        <translation>来自文件的固定点</translation>
    </message>
    <message>
        <source>%1 pins read from %2.</source>
        <translation>从 %2 读取了 %1 个固定点。</translation>
    </message>
    <message>
        <source>Pins written to %1.</source>
        <translation>固定点已写入 %1。</translation>
    </message>
    <message>
        <source>Looking for pins</source>
        <translation>寻找固定点</translation>
    </message>
    <message>
        <source>%1 pins are suggested. Click a faint ring to take one.</source>
        <translation>建议了 %1 个固定点。点击淡色圆环即可采用。</translation>
    </message>
    <message>
        <source>moldwright-render could not be started.</source>
        <translation>无法启动 moldwright-render。</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>它已停止。</translation>
    </message>
    <message>
        <source>Drawing the report</source>
        <translation>正在绘制报告</translation>
    </message>
    <message>
        <source>The report was not written. %1</source>
        <translation>未写入报告。%1</translation>
    </message>
    <message>
        <source>The report was not written.</source>
        <translation>未写入报告。</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>报告已写入 %1。</translation>
    </message>
    <message>
        <source>The run was stopped before it had a shape. The part is as it was.</source>
        <translation>运行在得到形状之前停止。零件保持原样。</translation>
    </message>
    <message>
        <source>Deform, stopped</source>
        <translation>变形，已停止</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>变形</translation>
    </message>
    <message>
        <source>Not castable yet: %1</source>
        <translation>尚不可铸造：%1</translation>
    </message>
    <message>
        <source>Filled: %1 % of the part&apos;s volume, at places that no bending frees.</source>
        <translation>已填充：零件体积的 %1 %，在弯曲无法解开之处。</translation>
    </message>
    <message>
        <source>%1 of %2 on side %3: filled.</source>
        <translation>第 %3 侧 %2 的%1：已填充。</translation>
    </message>
    <message>
        <source>Pins: %1, at most %2 mm from the plane.</source>
        <translation>固定点：%1 个，离平面最多 %2 mm。</translation>
    </message>
    <message>
        <source>Castable: proved at %1°, mean distance to the part %2 % of its diagonal.</source>
        <translation>可铸造：已证明 %1°，到零件的平均距离为其对角线的 %2 %。</translation>
    </message>
    <message>
        <source>The run was stopped. What it reached is kept, and not castable yet.</source>
        <translation>运行已停止。所达到的形状予以保留，尚不可铸造。</translation>
    </message>
    <message>
        <source>%1 % of the surface is below %2°. Run bends the part again, at the plane it had; Undo brings back what was before.</source>
        <translation>%1 % 的表面低于 %2°。运行会在原平面再次弯曲零件；撤销可回到之前。</translation>
    </message>
    <message>
        <source>Plane of the run</source>
        <translation>运行的平面</translation>
    </message>
    <message>
        <source>At this plane one place stands in the way, however the part is bent.</source>
        <translation>在此平面有一处阻碍，无论零件如何弯曲。</translation>
    </message>
    <message>
        <source>At this plane %1 places stand in the way, however the part is bent.</source>
        <translation>在此平面有 %1 处阻碍，无论零件如何弯曲。</translation>
    </message>
    <message>
        <source>Looking for undercuts</source>
        <translation>正在查找倒扣</translation>
    </message>
    <message>
        <source>%1 undercuts at this plane; %2 that no bending frees.</source>
        <translation>此平面有 %1 处倒扣；其中 %2 处弯曲无法解开。</translation>
    </message>
    <message>
        <source>Undercut by the rule</source>
        <translation>倒扣按规则处理</translation>
    </message>
    <message>
        <source>Fill an undercut</source>
        <translation>填充倒扣</translation>
    </message>
    <message>
        <source>Bend an undercut</source>
        <translation>弯曲倒扣</translation>
    </message>
    <message>
        <source>Fill an obstruction</source>
        <translation>填充障碍</translation>
    </message>
    <message>
        <source>It will be filled. Nothing else stands in the way: Run bends the rest.</source>
        <translation>将予填充。再无其他阻碍：运行会弯曲其余部分。</translation>
    </message>
    <message>
        <source>It will be filled. One more place to decide on.</source>
        <translation>将予填充。还有一处待决定。</translation>
    </message>
    <message>
        <source>It will be filled. %1 more places to decide on.</source>
        <translation>将予填充。还有 %1 处待决定。</translation>
    </message>
    <message>
        <source>Region %1</source>
        <translation>区域 %1</translation>
    </message>
    <message>
        <source>Erase importance</source>
        <translation>擦除重要性</translation>
    </message>
    <message>
        <source>Paint importance</source>
        <translation>绘制重要性</translation>
    </message>
    <message>
        <source>Looking which faces are seen</source>
        <translation>查找可见的面</translation>
    </message>
    <message>
        <source>No face&apos;s middle is seen inside the lasso.</source>
        <translation>套索内看不到任何面的中心。</translation>
    </message>
    <message>
        <source>Change a region&apos;s weight</source>
        <translation>更改区域的权重</translation>
    </message>
    <message>
        <source>Change a region&apos;s limit</source>
        <translation>更改区域的限度</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Remove all regions</source>
        <translation>移除所有区域</translation>
    </message>
    <message>
        <source>Reading regions</source>
        <translation>读取区域</translation>
    </message>
    <message>
        <source>Regions from a file</source>
        <translation>从文件读区域</translation>
    </message>
    <message>
        <source>%1 regions read from %2.</source>
        <translation>已从 %2 读取 %1 个区域。</translation>
    </message>
    <message>
        <source>Regions written to %1.</source>
        <translation>区域已写入 %1。</translation>
    </message>
    <message>
        <source>%1 kept its shape within %2 mm: it changed by %3 mm.</source>
        <translation>%1 的形状保持在 %2 mm 之内：变化了 %3 mm。</translation>
    </message>
    <message>
        <source>%1 changed its shape by %2 mm, more than the %3 mm allowed. Give it more weight, or take another plane.</source>
        <translation>%1 的形状变化了 %2 mm，超过允许的 %3 mm。请增加权重，或换一个平面。</translation>
    </message>
    <message>
        <source>Changed during the run</source>
        <translation>运行期间的更改</translation>
    </message>
    <message>
        <source>The run has ended without the last changes.</source>
        <translation>运行已结束，未包含最后的更改。</translation>
    </message>
    <message>
        <source>Run bends the part with them; Undo brings back the cast without them.</source>
        <translation>再次运行会按这些更改变形；撤销可恢复未包含更改的铸件。</translation>
    </message>
    <message>
        <source>A run cannot take this up while it goes on. The next run does.</source>
        <translation>运行中无法采用此更改，下次运行时生效。</translation>
    </message>
    <message>
        <source>Go on from step %1</source>
        <translation>从第 %1 步继续</translation>
    </message>
    <message>
        <source>Variant %1</source>
        <translation>变型 %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>复制 %1</translation>
    </message>
    <message>
        <source>%1 is a copy of %2, and the current variant now.</source>
        <translation>%1 是 %2 的副本，现在是当前变型。</translation>
    </message>
    <message>
        <source>New variant</source>
        <translation>新建变型</translation>
    </message>
    <message>
        <source>%1 is a new variant, without pins and regions, and the current one now.</source>
        <translation>%1 是新变型，没有固定点和区域，现在是当前变型。</translation>
    </message>
    <message>
        <source>There is a variant %1 already. Take another name.</source>
        <translation>已有变型 %1。请取另一个名称。</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动%1</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>固定点 %1</translation>
    </message>
    <message>
        <source>Change regions' weights</source>
        <translation>更改多个区域的权重</translation>
    </message>
    <message>
        <source>Change regions' limits</source>
        <translation>更改多个区域的限值</translation>
    </message>
    <message>
        <source>Remove %1 regions</source>
        <translation>移除 %1 个区域</translation>
    </message>
    <message>
        <source>Remove %1 pins</source>
        <translation>移除 %1 个固定点</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>正在修复 %1</translation>
    </message>
    <message>
        <source>Repairing</source>
        <translation>修复</translation>
    </message>
    <message>
        <source>No undercut at this plane.</source>
        <translation>此平面没有倒扣。</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>读取 %1</translation>
    </message>
    <message>
        <source>Reading %1 parts</source>
        <translation>读取 %1 个零件</translation>
    </message>
    <message>
        <source>Add %1 to the mold</source>
        <translation>向模具添加 %1</translation>
    </message>
    <message>
        <source>Add %1 parts to the mold</source>
        <translation>向模具添加 %1 个零件</translation>
    </message>
    <message>
        <source>%1 has a cavity in the mold now.</source>
        <translation>%1 现在在模具中有一个型腔。</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>重新读取 %1</translation>
    </message>
    <message>
        <source>%1 is in its file as it is in the mold.</source>
        <translation>%1 在其文件中与在模具中相同。</translation>
    </message>
    <message>
        <source>%1 was read again.</source>
        <translation>已重新读取 %1。</translation>
    </message>
    <message>
        <source>Cavities of %1</source>
        <translation>%1 的型腔数</translation>
    </message>
</context>
<context>
    <name>moldwright::WorkflowBar</name>
    <message>
        <source>Workflow</source>
        <translation>工作流程</translation>
    </message>
</context>
<context>
    <name>pins</name>
    <message>
        <source>The search for pins was cancelled.</source>
        <translation>固定点的搜索已取消。</translation>
    </message>
</context>
<context>
    <name>moldwright::PaintTool</name>
    <message>
        <source>A lasso looks for its faces once the run has ended. The other brushes paint while it goes on.</source>
        <translation>套索要等运行结束后才查找其中的面。其他画笔在运行期间也能绘制。</translation>
    </message>
</context>
<context>
    <name>Presets</name>
    <message>
        <source>Save as a preset</source>
        <translation>保存为预设</translation>
    </message>
    <message>
        <source>Name; one that is there already is replaced:</source>
        <translation>名称；同名预设将被替换：</translation>
    </message>
    <message>
        <source>The settings are none of the presets. Take one over to remove it.</source>
        <translation>当前设置不是任何预设。请先采用要移除的预设。</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Block, layout, features and machines as they were saved under a name. Shrink and density stay as they are.</source>
        <translation>以某名称保存的模块、布局、结构和设备。收缩率和密度保持不变。</translation>
    </message>
    <message>
        <source>As set here</source>
        <translation>按此处设置</translation>
    </message>
    <message>
        <source>There is no preset {0}: none has been saved yet in {1}.</source>
        <translation>没有预设 {0}：{1} 中尚未保存任何预设。</translation>
    </message>
    <message>
        <source>There is no preset {0}. There are: {1}.</source>
        <translation>没有预设 {0}。现有：{1}。</translation>
    </message>
    <message>
        <source>The preset {0} cannot be understood. Save it anew, or remove it.</source>
        <translation>无法理解预设 {0}。请重新保存或移除。</translation>
    </message>
    <message>
        <source>A preset cannot be called “{0}”. Take up to 60 letters, digits, spaces, hyphens or dots between.</source>
        <translation>预设不能命名为“{0}”。请使用最多 60 个字母或数字，中间可含空格、连字符或点。</translation>
    </message>
    <message>
        <source>{0} could not be removed: {1}.</source>
        <translation>无法移除 {0}：{1}。</translation>
    </message>
</context>
<context>
    <name>moldwright::LostCardFrame</name>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>显示文件夹</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Puts it into the trash.</source>
        <translation>将其移到回收站。</translation>
    </message>
</context>
<context>
    <name>moldwright::Program</name>
    <message>
        <source>What is not saved is safe only while Moldwright runs. %1</source>
        <translation>未保存的内容仅在 Moldwright 运行期间安全。%1</translation>
    </message>
    <message>
        <source>%1 is open as it was, and is not saved.</source>
        <translation>%1 已按原样打开，尚未保存。</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>not run</source>
        <translation>未运行</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Variants of this part</source>
        <translation>此零件的变型</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>变型</translation>
    </message>
    <message>
        <source>Castable</source>
        <translation>可脱模</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>最小拔模角</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>Farthest, mm</source>
        <translation>最大偏差，mm</translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation>均方根，mm</translation>
    </message>
    <message>
        <source>Filled, cm³</source>
        <translation>填充，cm³</translation>
    </message>
    <message>
        <source>Block, mm</source>
        <translation>模块，mm</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步数</translation>
    </message>
    <message>
        <source>This report is of variant {0}. Castable: proved in exact arithmetic. Strain is the root of the mean square over the surface of both principal stretches less 1. Farthest and RMS are distances between cast and part after the best rigid fit. The block is that of the mold with the variant&apos;s own settings.</source>
        <translation>本报告针对变型 {0}。可脱模：以精确算术证明。应变为表面上两个主伸长率减 1 的均方根。最大偏差与均方根为最佳刚性配准后铸件与零件之间的距离。模块为按该变型自身设置生成的模具之模块。</translation>
    </message>
    <message>
        <source>{0} January {1}</source>
        <translation>{1}年1月{0}日</translation>
    </message>
    <message>
        <source>{0} February {1}</source>
        <translation>{1}年2月{0}日</translation>
    </message>
    <message>
        <source>{0} March {1}</source>
        <translation>{1}年3月{0}日</translation>
    </message>
    <message>
        <source>{0} April {1}</source>
        <translation>{1}年4月{0}日</translation>
    </message>
    <message>
        <source>{0} May {1}</source>
        <translation>{1}年5月{0}日</translation>
    </message>
    <message>
        <source>{0} June {1}</source>
        <translation>{1}年6月{0}日</translation>
    </message>
    <message>
        <source>{0} July {1}</source>
        <translation>{1}年7月{0}日</translation>
    </message>
    <message>
        <source>{0} August {1}</source>
        <translation>{1}年8月{0}日</translation>
    </message>
    <message>
        <source>{0} September {1}</source>
        <translation>{1}年9月{0}日</translation>
    </message>
    <message>
        <source>{0} October {1}</source>
        <translation>{1}年10月{0}日</translation>
    </message>
    <message>
        <source>{0} November {1}</source>
        <translation>{1}年11月{0}日</translation>
    </message>
    <message>
        <source>{0} December {1}</source>
        <translation>{1}年12月{0}日</translation>
    </message>
    <message>
        <source>own choice</source>
        <translation>自选</translation>
    </message>
    <message>
        <source>open mold generators</source>
        <translation>开源模具生成器</translation>
    </message>
    <message>
        <source>shop practice</source>
        <translation>车间惯例</translation>
    </message>
    <message>
        <source>Spout, diameter</source>
        <translation>浇口直径</translation>
    </message>
    <message>
        <source>Spout, at the block’s face</source>
        <translation>浇口在模块表面处</translation>
    </message>
    <message>
        <source>Gate, width</source>
        <translation>浇道口宽度</translation>
    </message>
    <message>
        <source>Channels, draft</source>
        <translation>流道拔模角</translation>
    </message>
    <message>
        <source>Neck of the spout</source>
        <translation>浇口颈部</translation>
    </message>
    <message>
        <source>Vents, at the narrowest</source>
        <translation>排气最窄处</translation>
    </message>
    <message>
        <source>gravity pour, shop practice</source>
        <translation>重力浇注，车间惯例</translation>
    </message>
    <message>
        <source>Air that may stay</source>
        <translation>允许残留的空气</translation>
    </message>
    <message>
        <source>Keys, diameter</source>
        <translation>定位销直径</translation>
    </message>
    <message>
        <source>Keys, height</source>
        <translation>定位销高度</translation>
    </message>
    <message>
        <source>Keys, clearance</source>
        <translation>定位销间隙</translation>
    </message>
    <message>
        <source>Keys, draft at least</source>
        <translation>定位销最小拔模角</translation>
    </message>
    <message>
        <source>First key larger by</source>
        <translation>第一个定位销加大</translation>
    </message>
    <message>
        <source>Wedge slits, depth</source>
        <translation>撬模槽深度</translation>
    </message>
    <message>
        <source>mold makers</source>
        <translation>模具制造商</translation>
    </message>
    <message>
        <source>Wedge slits, width</source>
        <translation>撬模槽宽度</translation>
    </message>
    <message>
        <source>Wedge slits, height in each half</source>
        <translation>撬模槽在每半模的高度</translation>
    </message>
    <message>
        <source>Bolt holes, diameter</source>
        <translation>螺栓孔直径</translation>
    </message>
    <message>
        <source>M6, ISO 273 medium</source>
        <translation>M6，ISO 273 中等</translation>
    </message>
    <message>
        <source>Bolt holes, steel to faces</source>
        <translation>螺栓孔到外表面的钢材</translation>
    </message>
    <message>
        <source>Bolt holes, steel to the rest</source>
        <translation>螺栓孔到其他特征的钢材</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>侧壁</translation>
    </message>
    <message>
        <source>open mold generators, 1.5 to 25 mm</source>
        <translation>开源模具生成器，1.5 至 25 mm</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>底厚</translation>
    </message>
    <message>
        <source>as the wall</source>
        <translation>同侧壁</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>顶厚</translation>
    </message>
    <message>
        <source>Sizes round up to</source>
        <translation>尺寸取整至</translation>
    </message>
    <message>
        <source>Cavity pressure</source>
        <translation>型腔压力</translation>
    </message>
    <message>
        <source>no source: set it to your process</source>
        <translation>无来源：请按工艺设定</translation>
    </message>
    <message>
        <source>Clamp allowance</source>
        <translation>锁模余量</translation>
    </message>
    <message>
        <source>1.1 to 1.2 in shop practice</source>
        <translation>车间惯例 1.1 至 1.2</translation>
    </message>
    <message>
        <source>Mix allowance</source>
        <translation>配料余量</translation>
    </message>
    <message>
        <source>Ejector holes, diameter</source>
        <translation>顶针孔直径</translation>
    </message>
    <message>
        <source>length {0}</source>
        <translation>长 {0}</translation>
    </message>
    <message>
        <source>width {0}</source>
        <translation>宽 {0}</translation>
    </message>
    <message>
        <source>depth {0}</source>
        <translation>深 {0}</translation>
    </message>
    <message>
        <source>height {0}</source>
        <translation>高 {0}</translation>
    </message>
    <message>
        <source>{0} into half 1</source>
        <translation>半模 1 内 {0}</translation>
    </message>
    <message>
        <source>{0} into half 2</source>
        <translation>半模 2 内 {0}</translation>
    </message>
    <message>
        <source>clearance {0}</source>
        <translation>间隙 {0}</translation>
    </message>
    <message>
        <source>Way from the spout to each cavity</source>
        <translation>从浇口到各型腔的流程</translation>
    </message>
    <message>
        <source>equally long, {0}</source>
        <translation>等长，{0}</translation>
    </message>
    <message>
        <source>neck ⌀ {0}</source>
        <translation>颈部 ⌀ {0}</translation>
    </message>
    <message>
        <source>lean {0}</source>
        <translation>倾角 {0}</translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>型腔</translation>
    </message>
    <message>
        <source>Cavity, mirrored</source>
        <translation>型腔（镜像）</translation>
    </message>
    <message>
        <source>Spout</source>
        <translation>浇口</translation>
    </message>
    <message>
        <source>Spout through half 1</source>
        <translation>穿过半模 1 的浇口</translation>
    </message>
    <message>
        <source>Runner</source>
        <translation>流道</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>浇道口</translation>
    </message>
    <message>
        <source>Vent</source>
        <translation>排气</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>定位销</translation>
    </message>
    <message>
        <source>Wedge slit</source>
        <translation>撬模槽</translation>
    </message>
    <message>
        <source>Bolt hole</source>
        <translation>螺栓孔</translation>
    </message>
    <message>
        <source>Ejector hole in half 1</source>
        <translation>半模 1 中的顶针孔</translation>
    </message>
    <message>
        <source>Ejector hole in half 2</source>
        <translation>半模 2 中的顶针孔</translation>
    </message>
    <message>
        <source>Air that stays</source>
        <translation>残留空气</translation>
    </message>
    <message>
        <source>Overflow</source>
        <translation>溢料井</translation>
    </message>
    <message>
        <source>Insert pocket in both halves</source>
        <translation>两半模中的嵌件槽</translation>
    </message>
    <message>
        <source>Insert pocket in half 1</source>
        <translation>半模 1 中的嵌件槽</translation>
    </message>
    <message>
        <source>Insert pocket in half 2</source>
        <translation>半模 2 中的嵌件槽</translation>
    </message>
    <message>
        <source>Plaque on half 1</source>
        <translation>半模 1 上的铭牌</translation>
    </message>
    <message>
        <source>Plaque on half 2</source>
        <translation>半模 2 上的铭牌</translation>
    </message>
    <message>
        <source>overflow</source>
        <translation>溢料井</translation>
    </message>
    <message>
        <source>overflow&apos;s channel</source>
        <translation>溢流通道</translation>
    </message>
    <message>
        <source>pocket</source>
        <translation>嵌件槽</translation>
    </message>
    <message>
        <source>plaque</source>
        <translation>铭牌</translation>
    </message>
    <message>
        <source>the right</source>
        <translation>右方</translation>
    </message>
    <message>
        <source>the left</source>
        <translation>左方</translation>
    </message>
    <message>
        <source>half 1</source>
        <translation>半模 1</translation>
    </message>
    <message>
        <source>half 2</source>
        <translation>半模 2</translation>
    </message>
    <message>
        <source>half 1 and the right</source>
        <translation>半模 1 和右方</translation>
    </message>
    <message>
        <source>half 1 and the left</source>
        <translation>半模 1 和左方</translation>
    </message>
    <message>
        <source>half 2 and the left</source>
        <translation>半模 2 和左方</translation>
    </message>
    <message>
        <source>half 2 and the right</source>
        <translation>半模 2 和右方</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>后方</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>前方</translation>
    </message>
    <message>
        <source>the back and the right</source>
        <translation>右后方</translation>
    </message>
    <message>
        <source>the back and the left</source>
        <translation>左后方</translation>
    </message>
    <message>
        <source>the front and the left</source>
        <translation>左前方</translation>
    </message>
    <message>
        <source>the front and the right</source>
        <translation>右前方</translation>
    </message>
    <message>
        <source>cavity</source>
        <translation>型腔</translation>
    </message>
    <message>
        <source>spout</source>
        <translation>浇口</translation>
    </message>
    <message>
        <source>runner</source>
        <translation>流道</translation>
    </message>
    <message>
        <source>gate</source>
        <translation>浇道口</translation>
    </message>
    <message>
        <source>vent</source>
        <translation>排气</translation>
    </message>
    <message>
        <source>key</source>
        <translation>定位销</translation>
    </message>
    <message>
        <source>slit</source>
        <translation>撬模槽</translation>
    </message>
    <message>
        <source>bolt hole</source>
        <translation>螺栓孔</translation>
    </message>
    <message>
        <source>ejector hole</source>
        <translation>顶针孔</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>Cavities and features</source>
        <translation>型腔与特征</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>特征</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Each</source>
        <translation>每个</translation>
    </message>
    <message>
        <source>Not castable yet</source>
        <translation>尚不可脱模</translation>
    </message>
    <message>
        <source>No cast has been made of this part. Required draft {0}.</source>
        <translation>尚未由此零件得到铸件。要求的拔模角 {0}。</translation>
    </message>
    <message>
        <source>No mold yet</source>
        <translation>尚无模具</translation>
    </message>
    <message>
        <source>The cast is there, its mold could not be built. Required draft {0}.</source>
        <translation>铸件已有，但无法生成其模具。要求的拔模角 {0}。</translation>
    </message>
    <message>
        <source>Castable. The mold opens.</source>
        <translation>可脱模。模具可以打开。</translation>
    </message>
    <message>
        <source>Proved on the written halves for every face: draft {0} or more, where {1} is required.</source>
        <translation>已在写出的两半模上逐面证明：拔模角不小于 {0}，要求为 {1}。</translation>
    </message>
    <message>
        <source>The mold is not proved to open. Open items are on page 2.</source>
        <translation>尚未证明模具可以打开。未决事项见第 2 页。</translation>
    </message>
    <message>
        <source>none, factor 1</source>
        <translation>无，系数 1</translation>
    </message>
    <message>
        <source>{0} %, {1}: factor {2}</source>
        <translation>{0} %，{1}：系数 {2}</translation>
    </message>
    <message>
        <source>x {0}, y {1}, z {2} %, {3}: factors {4}, {5}, {6}</source>
        <translation>x {0}，y {1}，z {2} %，{3}：系数 {4}，{5}，{6}</translation>
    </message>
    <message>
        <source>Smallest steel</source>
        <translation>最薄钢材</translation>
    </message>
    <message>
        <source>Smallest steel, {0} to {1}</source>
        <translation>最薄钢材，{0}到{1}</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Read from</source>
        <translation>读取自</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>millimetres, degrees</source>
        <translation>毫米，度</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>收缩率</translation>
    </message>
    <message>
        <source>no mold yet</source>
        <translation>尚无模具</translation>
    </message>
    <message>
        <source>Parting plane and directions</source>
        <translation>分型面与方向</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0}，相对 {1}</translation>
    </message>
    <message>
        <source>Plane, n · x = o</source>
        <translation>平面，n · x = o</translation>
    </message>
    <message>
        <source>Direction 1</source>
        <translation>方向 1</translation>
    </message>
    <message>
        <source>Direction 2</source>
        <translation>方向 2</translation>
    </message>
    <message>
        <source>Tilted while it is filled</source>
        <translation>充填时倾斜</translation>
    </message>
    <message>
        <source>Better tilted while it is filled</source>
        <translation>充填时宜倾斜</translation>
    </message>
    <message>
        <source>{0}° towards {1}
air: {2} mm³, upright {3} mm³</source>
        <translation>{0}°，向{1}
空气：{2} mm³，直立时 {3} mm³</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Volume of the part</source>
        <translation>零件体积</translation>
    </message>
    <message>
        <source>Cavity, as cut</source>
        <translation>型腔（按切削）</translation>
    </message>
    <message>
        <source>Mix, with 10 % allowance</source>
        <translation>配料，含 10 % 余量</translation>
    </message>
    <message>
        <source>Projected area in the plane</source>
        <translation>分型面上的投影面积</translation>
    </message>
    <message>
        <source>Clamp force, {0} bar × 1.1</source>
        <translation>锁模力，{0} bar × 1.1</translation>
    </message>
    <message>
        <source>Mold, closed</source>
        <translation>模具（闭合）</translation>
    </message>
    <message>
        <source>Kept from the part</source>
        <translation>零件的保留程度</translation>
    </message>
    <message>
        <source>Mean deviation, after best fit</source>
        <translation>最佳配准后平均偏差</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>最大偏差</translation>
    </message>
    <message>
        <source>Volume, cast over part</source>
        <translation>体积，铸件比零件</translation>
    </message>
    <message>
        <source>Filled in</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Opens along, mold’s frame</source>
        <translation>开模方向（模具坐标）</translation>
    </message>
    <message>
        <source>Mold half 1</source>
        <translation>半模 1</translation>
    </message>
    <message>
        <source>Mold half 2</source>
        <translation>半模 2</translation>
    </message>
    <message>
        <source>The cast is closed, manifold and outward</source>
        <translation>铸件封闭、流形且朝外</translation>
    </message>
    <message>
        <source>Each direction leaves the parting plane on its side</source>
        <translation>每个方向都从分型面自己的一侧离开</translation>
    </message>
    <message>
        <source>Every face has a draft of {0} or more, in exact arithmetic</source>
        <translation>每个面的拔模角不小于 {0}，以精确算术证明</translation>
    </message>
    <message>
        <source>No face lies across the parting plane</source>
        <translation>没有面跨越分型面</translation>
    </message>
    <message>
        <source>The parting line is simple and nested, seen along both directions</source>
        <translation>沿两个方向看，分型线简单且相互嵌套</translation>
    </message>
    <message>
        <source>The cast does not cross itself</source>
        <translation>铸件不自相交</translation>
    </message>
    <message>
        <source>Both halves are closed, in one piece, and free to move at any distance</source>
        <translation>两半模封闭、各为一体，在任意距离上都能自由移动</translation>
    </message>
    <message>
        <source>{0}: shape changed by {1}, no limit</source>
        <translation>{0}：形状改变 {1}，无限制</translation>
    </message>
    <message>
        <source>{0}: shape changed by {1}, {2} allowed</source>
        <translation>{0}：形状改变 {1}，允许 {2}</translation>
    </message>
    <message>
        <source>{0}: shape changed by {1}, more than the {2} allowed.</source>
        <translation>{0}：形状改变 {1}，超过允许的 {2}。</translation>
    </message>
    <message>
        <source>Red below {0}: {1}</source>
        <translation>低于 {0} 为红色：{1}</translation>
    </message>
    <message>
        <source>As read</source>
        <translation>读入时</translation>
    </message>
    <message>
        <source>Mean deviation {0} mm</source>
        <translation>平均偏差 {0} mm</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>尚无</translation>
    </message>
    <message>
        <source>Build the mold.</source>
        <translation>请生成模具。</translation>
    </message>
    <message>
        <source>Make the part castable, then build the mold.</source>
        <translation>请先使零件可脱模，再生成模具。</translation>
    </message>
    <message>
        <source>Mold design report</source>
        <translation>模具设计报告</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>文件 %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>无图片</translation>
    </message>
    <message>
        <source>below −15°</source>
        <translation>低于 −15°</translation>
    </message>
    <message>
        <source>−15 to −5°</source>
        <translation>−15 至 −5°</translation>
    </message>
    <message>
        <source>−5 to 0°</source>
        <translation>−5 至 0°</translation>
    </message>
    <message>
        <source>0 to %1°</source>
        <translation>0 至 %1°</translation>
    </message>
    <message>
        <source>%1 to 3°</source>
        <translation>%1 至 3°</translation>
    </message>
    <message>
        <source>3 to 10°</source>
        <translation>3 至 10°</translation>
    </message>
    <message>
        <source>10° and more</source>
        <translation>10° 及以上</translation>
    </message>
    <message>
        <source>Half %1</source>
        <translation>半模 %1</translation>
    </message>
    <message>
        <source>worst %1°, mean %2°</source>
        <translation>最小 %1°，平均 %2°</translation>
    </message>
    <message>
        <source>%1° required</source>
        <translation>要求 %1°</translation>
    </message>
    <message>
        <source>Cast</source>
        <translation>铸件</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>拔模角</translation>
    </message>
    <message>
        <source>Scale below, dark is bad</source>
        <translation>色标见下，越深越差</translation>
    </message>
    <message>
        <source>Draft, area in cm² per 5°</source>
        <translation>拔模角，每 5° 的面积（cm²）</translation>
    </message>
    <message>
        <source>Part and cast</source>
        <translation>零件与铸件</translation>
    </message>
    <message>
        <source>Mold</source>
        <translation>模具</translation>
    </message>
    <message>
        <source>Half 2 left, half 1 right, parting faces up</source>
        <translation>左为半模 2，右为半模 1，分型面朝上</translation>
    </message>
    <message>
        <source>Not a simulation of filling, warpage or cooling.
Open items: %1.</source>
        <translation>不是充填、翘曲或冷却的模拟。
未决事项：%1。</translation>
    </message>
    <message>
        <source>%1, see page 2</source>
        <translation>%1，见第 2 页</translation>
    </message>
    <message>
        <source>Important regions, each after its own best fit</source>
        <translation>重要区域，各自最佳配准后</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>另有 %1 项</translation>
    </message>
    <message>
        <source>Open items</source>
        <translation>未决事项</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>无。</translation>
    </message>
    <message>
        <source>Drawn by</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>校对</translation>
    </message>
    <message>
        <source>Approved by</source>
        <translation>批准</translation>
    </message>
    <message>
        <source>Mold and proof</source>
        <translation>模具与证明</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Each half along its own direction, the cast between</source>
        <translation>每半模沿各自方向，铸件居中</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>钢料</translation>
    </message>
    <message>
        <source>Behind the walls, in mm; too thin is red</source>
        <translation>型壁之后，毫米；过薄为红色</translation>
    </message>
    <message>
        <source>Certificate, on the written halves</source>
        <translation>证书，针对写出的两半模</translation>
    </message>
    <message>
        <source>Proved in exact arithmetic on the coordinates as they stand in the files. The proof speaks of rigid motion along the two directions; it is not a simulation of filling, warpage, cooling or friction.</source>
        <translation>按文件中的坐标以精确算术证明。证明针对沿两个方向的刚性运动；不是充填、翘曲、冷却或摩擦的模拟。</translation>
    </message>
    <message>
        <source>Defaults used</source>
        <translation>使用的默认值</translation>
    </message>
    <message>
        <source>Features of the mold</source>
        <translation>模具的特征</translation>
    </message>
    <message>
        <source>Defaults used for them</source>
        <translation>为其使用的默认值</translation>
    </message>
    <message>
        <source>To be known</source>
        <translation>须知</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>变型</translation>
    </message>
    <message>
        <source>The report {0} could not be written. Choose another folder or free some space.</source>
        <translation>无法写出报告 {0}。请选择其他文件夹或腾出空间。</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>型腔</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Taken from the material</source>
        <translation>取自材料</translation>
    </message>
</context>
<context>
    <name>SteelPaint</name>
    <message>
        <source>Steel</source>
        <translation>钢料厚度</translation>
    </message>
    <message>
        <source>below %1, the least asked for</source>
        <translation>小于 %1（要求的最小值）</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 或更厚</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Shown on the halves: build the mold, or choose it.</source>
        <translation>显示在模具两半上：请先生成或选中模具。</translation>
    </message>
    <message>
        <source>behind the walls, thinnest %1</source>
        <translation>型壁之后，最薄 %1</translation>
    </message>
</context>
<context>
    <name>RefusalPages</name>
    <message>
        <source>Holes</source>
        <translation>孔洞</translation>
    </message>
    <message>
        <source>Crowded edges</source>
        <translation>多面共边</translation>
    </message>
    <message>
        <source>Touching points</source>
        <translation>接触点</translation>
    </message>
    <message>
        <source>One-sided places</source>
        <translation>单侧处</translation>
    </message>
    <message>
        <source>Faces without area</source>
        <translation>零面积面</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>自相交处</translation>
    </message>
    <message>
        <source>Closed surfaces inside</source>
        <translation>内部封闭曲面</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <translation>孔洞 %1</translation>
    </message>
    <message>
        <source>Crowded edge %1</source>
        <translation>多面共边 %1</translation>
    </message>
    <message>
        <source>Touching point %1</source>
        <translation>接触点 %1</translation>
    </message>
    <message>
        <source>One-sided place %1</source>
        <translation>单侧处 %1</translation>
    </message>
    <message>
        <source>Face without area %1</source>
        <translation>零面积面 %1</translation>
    </message>
    <message>
        <source>Crossing %1</source>
        <translation>自相交 %1</translation>
    </message>
    <message>
        <source>Closed surface inside %1</source>
        <translation>内部封闭曲面 %1</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 条边</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 个面</translation>
    </message>
    <message>
        <source>No volume</source>
        <translation>无体积</translation>
    </message>
    <message>
        <source>Ways out</source>
        <translation>解决办法</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X, Y, Z</source>
        <translation>X, Y, Z</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边</translation>
    </message>
    <message>
        <source>Lengths are those of the file.</source>
        <translation>长度采用文件中的数值。</translation>
    </message>
    <message>
        <source>Needs a sound mesh</source>
        <translation>需要完好的网格</translation>
    </message>
    <message>
        <source>Cannot be cast yet</source>
        <translation>尚不能铸造</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>无法使用</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>曲面</translation>
    </message>
    <message>
        <source>Read, and not ready for a mold.</source>
        <translation>已读取，但还不能用于制模。</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>封闭</translation>
    </message>
    <message>
        <source>Manifold</source>
        <translation>流形</translation>
    </message>
    <message>
        <source>Faces look outward</source>
        <translation>面朝外</translation>
    </message>
    <message>
        <source>Pairs that cross</source>
        <translation>相交面对</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>部分数</translation>
    </message>
    <message>
        <source>Mended while reading</source>
        <translation>读取时已修复</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Mesh problems</source>
        <translation>网格问题</translation>
    </message>
    <message>
        <source>Repair fills holes, splits and drops what too many faces share, and makes faces anew where they cross; where that does not help, a closed skin about the surface. Messages tell what was done.</source>
        <translation>修复会填补孔洞，拆分或去除被过多面共用的部分，并在面相交处重新生成面；若仍无效，则在表面外做一层封闭外壳。消息中会说明做了什么。</translation>
    </message>
    <message>
        <source>Or mend the mesh in the program that made it and write the file again; then read it again here. What was open before is as it was.</source>
        <translation>或者在生成该网格的程序中修补并重新写出文件，然后在此重新读取。之前打开的内容保持不变。</translation>
    </message>
</context>
<context>
    <name>ChosenFeatures</name>
    <message>
        <source>%1 features of the mold</source>
        <translation>%1 个模具特征</translation>
    </message>
    <message>
        <source>Each is placed on its own; these are given back together.</source>
        <translation>每个单独放置；可一起交还给程序。</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>已选</translation>
    </message>
</context>
<context>
    <name>moldwright::QuantitySpinBox</name>
    <message>
        <source>mixed</source>
        <translation>不一</translation>
    </message>
</context>
<context>
    <name>moldwright::PinOffers</name>
    <message>
        <source>Looking for pins</source>
        <translation>寻找固定点</translation>
    </message>
    <message>
        <source>Take a suggested pin</source>
        <translation>采用建议的固定点</translation>
    </message>
    <message>
        <source>Pin the ends of limbs</source>
        <translation>固定肢端</translation>
    </message>
    <message>
        <source>Take suggested pins</source>
        <translation>采用建议的固定点</translation>
    </message>
</context>
<context>
    <name>moldwright::OpeningBar</name>
    <message>
        <source>How far the mold is open</source>
        <translation>模具打开多少</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>闭合</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>正在打开</translation>
    </message>
    <message>
        <source>apart</source>
        <translation>分开</translation>
    </message>
    <message>
        <source>turning over</source>
        <translation>翻转中</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>并排</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
</context>
<context>
    <name>moldwright::SteelTable</name>
    <message>
        <source>Steel between features</source>
        <translation>特征之间的钢料</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>钢料</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>The steel between the features of the mold, once it is built or they are placed.</source>
        <translation>模具建成或特征放置后，此处列出特征之间的钢料厚度。</translation>
    </message>
</context>
<context>
    <name>MaterialPages</name>
    <message>
        <source>Not chosen</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>%1, as in this project</source>
        <translation>%1(与此项目中相同)</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Sets shrink, its formula, density and the depth of vents; all can be changed below.</source>
        <translation>设定收缩率、其公式、密度和排气槽深度;均可在下方更改。</translation>
    </message>
    <message>
        <source>Draft here</source>
        <translation>此处的斜度</translation>
    </message>
    <message>
        <source>And what is usual for the material.</source>
        <translation>以及该材料的常用值。</translation>
    </message>
    <message>
        <source>Choose a material first.</source>
        <translation>请先选择材料。</translation>
    </message>
    <message>
        <source>Take the material's draft</source>
        <translation>采用材料的斜度</translation>
    </message>
</context>
<context>
    <name>moldwright::MaterialForm</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>工艺</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Process</source>
        <translation>工艺(&amp;P)</translation>
    </message>
    <message>
        <source>%1, range</source>
        <translation>%1,范围</translation>
    </message>
    <message>
        <source>%1, source</source>
        <translation>%1,来源</translation>
    </message>
    <message>
        <source>%1, status</source>
        <translation>%1,可靠性</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>可靠性</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>收缩率</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>斜度</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Vents' depth</source>
        <translation>排气槽深度</translation>
    </message>
    <message>
        <source>In the parting plane, both halves together; 0: as their width asks.</source>
        <translation>分型面内,两半合计;0:按其宽度确定。</translation>
    </message>
    <message>
        <source>Made larger by</source>
        <translation>放大方式</translation>
    </message>
    <message>
        <source>Made &amp;larger by</source>
        <translation>放大方式(&amp;L)</translation>
    </message>
    <message>
        <source>N&amp;otes</source>
        <translation>备注(&amp;O)</translation>
    </message>
    <message>
        <source>S&amp;ealing</source>
        <translation>封闭(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Release agent</source>
        <translation>脱模剂(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Filling</source>
        <translation>填充(&amp;F)</translation>
    </message>
    <message>
        <source>Se&amp;tting</source>
        <translation>固化(&amp;T)</translation>
    </message>
    <message>
        <source>Source of these</source>
        <translation>以上来源</translation>
    </message>
</context>
<context>
    <name>moldwright::MaterialDialog</name>
    <message>
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>A material of your own, with the values of the one that is chosen.</source>
        <translation>以所选材料的数值新建自己的材料。</translation>
    </message>
    <message>
        <source>Yours. A project keeps the values it was given; choose the material there anew to have these.</source>
        <translation>您自己的材料。项目保留当时的数值;在项目中重新选择该材料即可采用这些数值。</translation>
    </message>
    <message>
        <source>Comes with the program. What you change is kept as your own.</source>
        <translation>随程序提供。您的更改会作为自己的材料保存。</translation>
    </message>
    <message>
        <source>As &amp;before</source>
        <translation>恢复原值(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>删除(&amp;R)</translation>
    </message>
    <message>
        <source>Take the values again that come with the program.</source>
        <translation>恢复程序自带的数值。</translation>
    </message>
    <message>
        <source>Forget this material of yours.</source>
        <translation>删除您的这种材料。</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1(自定)</translation>
    </message>
</context>
<context>
    <name>TrayPages</name>
    <message>
        <source>Part %1</source>
        <translation>零件 %1</translation>
    </message>
    <message>
        <source>%1 cavities: %2</source>
        <translation>%1 个型腔：%2</translation>
    </message>
    <message>
        <source>All places of the layout that the other parts leave.</source>
        <translation>布局中其他零件留下的所有位置。</translation>
    </message>
    <message>
        <source>How many cavities the mold has of it.</source>
        <translation>模具中该零件的型腔数。</translation>
    </message>
    <message>
        <source>Two halves around the cast.</source>
        <translation>围绕铸件的两个半模。</translation>
    </message>
    <message>
        <source>Parts in the mold</source>
        <translation>模具中的零件</translation>
    </message>
    <message>
        <source>The cast of this project, in its mold.</source>
        <translation>本项目的铸件，在其模具中。</translation>
    </message>
    <message>
        <source>A further part in the same mold.</source>
        <translation>同一模具中的另一个零件。</translation>
    </message>
    <message>
        <source>In the mold</source>
        <translation>在模具中</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>型腔</translation>
    </message>
    <message>
        <source>Its cast</source>
        <translation>其铸件</translation>
    </message>
    <message>
        <source>Read from</source>
        <translation>读取自</translation>
    </message>
    <message>
        <source>Worst draft</source>
        <translation>最小拔模角</translation>
    </message>
    <message>
        <source>Along its own directions; in the mold it leaves along those of the first part.</source>
        <translation>沿其自身的方向；在模具中它沿第一个零件的方向脱模。</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>尺寸，mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>this project</source>
        <translation>本项目</translation>
    </message>
</context>
</TS>
